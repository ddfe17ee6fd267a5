#pragma once

#include "case/case.hpp"
#include "case/judge.hpp"

namespace tt {

/// Keys of [cells] and [[kind]] that contradict each other or lack each other: how many cells of
/// which kind, and where.
void judge_cells(Judge& judge, const Case& c);

}  // namespace tt
