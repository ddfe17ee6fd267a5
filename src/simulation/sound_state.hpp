#pragma once

#include <string_view>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Throws DamagedArchive: the checkpoint cannot be loaded, and why.
[[noreturn]] void refuse_checkpoint(std::string_view why);

/// Before anything is computed from it: what was saved from a sound run is sound, but a file may be
/// forged, or have been in bad memory when its checksum was made. Throws DamagedArchive.
void expect_sound(const Model& model, const State& state);

}  // namespace tt
