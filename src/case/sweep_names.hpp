#pragma once

namespace tt {

struct SweepPlan;

/// Gives each run of the plan its name, "shear_number=0.1_seed=2", of letters that need no quotes
/// in a shell. A name that would be too long, or that another run has, ends with a checksum.
void name_runs(SweepPlan& plan);

}  // namespace tt
