#include "observe/snapshot.hpp"

#include "observe/cell_measures.hpp"
#include "observe/profiles.hpp"
#include "observe/run_measures.hpp"

namespace tt {

const std::vector<CellMeasures>& Snapshot::cells() const {
    if (!cells_) cells_ = measure_cells(model_, state_);
    return *cells_;
}

const RunMeasures& Snapshot::run() const {
    if (!run_) run_ = measure_run(model_, state_, cells());
    return *run_;
}

const Profiles& Snapshot::profiles() const {
    if (!profiles_) profiles_ = measure_profiles(model_, state_);
    return *profiles_;
}

}  // namespace tt
