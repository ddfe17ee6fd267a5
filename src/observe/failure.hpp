#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "observe/last_good.hpp"
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

/// Writes it anew, failure.json last, and returns the error that tells all of it, with the folder's
/// path. Brings the velocity of the failing state up to date with its populations. IoError if the
/// folder cannot be written.
SimulationError record_failure(const std::filesystem::path& results, const std::string& name,
                               const Instability& what, const Model& model, State& failing,
                               const LastGood& good);

}  // namespace tt
