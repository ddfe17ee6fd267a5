#pragma once

#include <string>
#include <string_view>

#include "report/results.hpp"

namespace tt {

/// What a run that blew up left: why, and a picture of the failing state, whole and near the place,
/// which is marked, over the last good one. HTML, under the heading `id`; empty for
/// a run that did not fail.
std::string failure_section(const Results& run, const std::string& label, std::string_view id);

}  // namespace tt
