#pragma once

#include <cstdint>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Where the case holds the mean velocity: every `drive_interval` steps the body force that does
/// so, from the mean velocity over all sites, along x or along a feed, just computed. One thread;
/// sums in a fixed order.
inline constexpr int drive_interval = 10;
inline bool drive_looks_at(const Model& model, std::int64_t step) {
    return model.drive.hold_mean_velocity && step % drive_interval == 0;
}
void hold_flow(const Model& model, State& state);

/// What drives the coming step where it changes in time: body force, and the factor of what each
/// port holds. One thread.
void follow_waves(const Model& model, State& state);

}  // namespace tt
