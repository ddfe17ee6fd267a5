#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "observe/last_good.hpp"
#include "observe/remedy.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// The folder failure/ of a results directory: what a run that blew up leaves behind.
///
///     why.txt       what was seen, where, why, and what to do
///     failure.json  the same for programs
///     last_good     the last sound state, a checkpoint to go on from
///     frames.h5     that state, if there is one, and the failing one, a frame each
///     failing       the failing state, an archive to look at
inline std::filesystem::path failure_folder(const std::filesystem::path& results) {
    return results / "failure";
}

/// Begins the folder anew with the states: last_good, frames.h5 and failing. Brings the velocity of
/// the failing state up to date with its populations.
void keep_states(const std::filesystem::path& results, const std::string& name, const Model& model,
                 State& failing, const LastGood& good);

/// Writes why.txt and failure.json and returns the error that tells the same.
SimulationError tell_failure(const std::filesystem::path& results, const Instability& what,
                             const Suggestion& advice, const LastGood& good, double dt);

/// The run of a results directory blew up before (exit 3): the same would happen again.
class FailedBefore : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

bool has_failed(const std::filesystem::path& results);

/// Throws FailedBefore, with all that was told.
[[noreturn]] void refuse_to_repeat(const std::filesystem::path& results);

/// Keeps the folder as failure.1, failure.2, …: the run has gone on.
void retire_failure(const std::filesystem::path& results);

}  // namespace tt
