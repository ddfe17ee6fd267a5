#pragma once

#include <string>

#include "io/archive.hpp"
#include "io/checksum.hpp"
#include "simulation/state.hpp"

namespace tt {

// What a checkpoint holds of a feed but for its channel, whose state is saved as that of the
// network (simulation/state_archive.hpp): which cells it leads, and who has come in.

void save_led(ArchiveOutput& archive, const FeedState& feed, const std::string& prefix);
/// Into `feed`, whose channel has been loaded, and `state.cells.led`. DamagedArchive where they do
/// not belong together.
void load_led(const ArchiveReader& archive, const std::string& prefix, FeedState& feed,
              State& state);
void hash_led(const FeedState& feed, Checksum& sum);

}  // namespace tt
