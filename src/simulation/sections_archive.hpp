#pragma once

#include "io/archive.hpp"
#include "io/checksum.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

// What a state knows of sections. Of a state without any nothing is written, and no bit of its hash
// is of them.

void save_sections(ArchiveOutput& archive, const State& state);
/// Into a state whose cells and departures have been loaded. DamagedArchive where it makes no
/// sense.
void load_sections(const ArchiveReader& archive, const Model& model, State& state);
void hash_sections(const State& state, Checksum& sum);

}  // namespace tt
