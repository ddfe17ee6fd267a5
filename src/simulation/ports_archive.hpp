#pragma once

#include "io/archive.hpp"
#include "io/checksum.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

// What a state knows of ports and of the cells that left through them. Of a state without ports
// nothing is written, and no bit of its hash is of them.

void save_ports(ArchiveOutput& archive, const State& state);
/// Into a state whose cells have been loaded and examined. DamagedArchive where it makes no sense.
void load_ports(const ArchiveReader& archive, const Model& model, State& state);
void hash_ports(const State& state, Checksum& sum);

}  // namespace tt
