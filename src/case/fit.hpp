#pragma once

#include "case/case.hpp"
#include "case/judge.hpp"

namespace tt {

/// Cells that are larger than the box, or too many for it, judged by their outline as it lies:
/// turned by `angle`, then stretched. A random layout may lay it any way that fits.
void judge_fit(Judge& judge, const Case& c);

/// Positions at which a cell reaches into a wall or into another.
void judge_positions(Judge& judge, const Case& c);

}  // namespace tt
