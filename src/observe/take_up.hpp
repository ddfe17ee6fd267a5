#pragma once

#include <cstdint>
#include <filesystem>

#include "exchange/exchange.hpp"
#include "io/archive.hpp"
#include "observe/checkpoints.hpp"
#include "observe/observers.hpp"
#include "observe/run_request.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// The state in a checkpoint, in the units of the model's time step, which may be another than that
/// of the run that wrote it. DamagedArchive if what the checkpoint holds cannot be of a run.
State take_up(ArchiveReader& archive, const Model& model, Exchange& exchange);

/// The step at which a run with another time step than that of `archive` goes on, near `step`: what
/// was due and done at the former step must not be due a step later. The step of a state that was
/// taken up is the nearest to its time; this is it, or the one after.
std::int64_t step_apart_from_looks(const ArchiveReader& archive, const Model& model,
                                   const Observers& observers, std::int64_t step);

/// Where no checkpoint is left: what is there may be what the very start of a run leaves, but must
/// not be results: finished or not, they are nobody's to write over. Throws DirectoryInUse.
void expect_nothing_to_lose(const std::filesystem::path& results, const RunRequest& request,
                            const Checkpoints& checkpoints);

/// Is frames.h5 still an index, which an earlier end could not put together?
bool frames_stay_apart(const std::filesystem::path& results);

/// Is all there that a run of just these settings leaves? summary.json is the last of it.
bool is_finished(const std::filesystem::path& results, const RunRequest& request);

}  // namespace tt
