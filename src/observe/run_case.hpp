#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "exchange/exchange.hpp"
#include "observe/checks.hpp"
#include "observe/run_request.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

struct RunOutcome {
    enum class Ending { done, was_done, stopped };
    Ending ending = Ending::done;
    std::int64_t step = 0;
    std::int64_t steps = 0;
    std::uint64_t state_hash = 0;  ///< 0 where no checkpoint was left to read it from
    double wall_seconds = 0.0;     ///< all sessions together
    std::vector<RunCheck> checks;  ///< of a run that is done
};

/// Runs the case into its results directory, or goes on with it, until its end, a signal,
/// `until` or the time limit; leaves the directory such that the same call goes on, to the same
/// bits as if it had never stopped. A call with a later end makes a finished run longer; rows and
/// frames that are there stay, later ones come as it asks. `initial` is called only for a run that
/// starts. Throws SimulationError (last good state in failure/), DirectoryInUse, IoError.
RunOutcome run_case(const RunRequest& request, const Model& model,
                    const std::function<State()>& initial, Exchange& exchange);

}  // namespace tt
