#pragma once

#include <cstdint>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Every `drive_interval` steps, from the velocity field just computed: the mean of u_x over all
/// sites and, where the case holds the mean velocity, the body force that does so. One thread; sums
/// in a fixed order.
inline constexpr int drive_interval = 10;
constexpr bool drive_looks_at(std::int64_t step) { return step % drive_interval == 0; }
void hold_flow(const Model& model, State& state);

}  // namespace tt
