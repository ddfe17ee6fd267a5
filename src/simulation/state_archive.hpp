#pragma once

#include <cstdint>
#include <string>

#include "exchange/exchange.hpp"
#include "io/archive.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Puts all of the State that is not derived: step, populations (sites only, no halo), cells,
/// drive, contact counters, where the cytoplasm was last laid, and the same of each feed. Of the
/// channel of a feed all names have `prefix` before them.
void save_state(ArchiveOutput& archive, const State& state, const std::string& prefix = {});

/// Gives `to` all that `save_state` puts of `from`, and leaves out what is derived: some 9 numbers
/// a site, into memory that `to` has already if it is of the same run.
void copy_saved(const State& from, State& to);

/// The state that `save_state` put, for the same model: 100 steps, save, load and 100 steps are 200
/// steps to the bit (tests/determinism/restart.cpp). DamagedArchive if its sizes are not those of
/// `model` or contradict each other.
State load_state(const ArchiveReader& archive, const Model& model, Exchange& exchange,
                 const std::string& prefix = {});

/// XXH64 of what `save_state` puts: equal for equal states, on any number of threads, before and
/// after a restart.
std::uint64_t state_hash(const State& state);

}  // namespace tt
