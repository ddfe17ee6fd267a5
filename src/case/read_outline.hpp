#pragma once

#include <string>
#include <string_view>

#include "case/case.hpp"

namespace tt {

/// The outline that the content of a file describes, as [cells] says it is to be read (`pixel`,
/// `y_down`, `smoothing`). `file` is its name in messages. Throws CaseError with every fault of the
/// text by line, or with the two places where the outline crosses or touches itself.
CellOutline read_outline(std::string_view bytes, const std::string& file,
                         const OutlineShape& shape);

}  // namespace tt
