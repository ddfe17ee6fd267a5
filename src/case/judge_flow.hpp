#pragma once

#include "case/case.hpp"
#include "case/judge.hpp"

namespace tt {

/// What no grid and no step can follow: a flow that is too slow or too fast for numbers, turbulent,
/// or that tears the cells.
void judge_flow(Judge& judge, const Case& c, bool with_cells);

}  // namespace tt
