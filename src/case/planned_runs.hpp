#pragma once

#include <string>
#include <vector>

#include "case/sweep_plan.hpp"

namespace tt {

/// A setting for every run, and where it was written.
struct CommonSetting {
    std::string text;  ///< as after --set
    Fault place;
};

/// Makes the runs of a plan whose axes are known: names, settings, cases, and the inputs that they
/// have. Adds every fault of them where it was written; the same one once.
void make_runs(SweepPlan& plan, const std::vector<CommonSetting>& set, std::vector<Fault>& faults);

}  // namespace tt
