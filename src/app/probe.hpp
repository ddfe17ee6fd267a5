#pragma once

#include <cstdint>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// What a short try of the real thing tells.
struct Probe {
    double steps_per_second = 0.0;  ///< 0: not tried
    double memory_bytes = 0.0;      ///< most that this process has held
    int threads = 1;
    std::int64_t unstable_step = 0;  ///< at which a node moved by half a site or more; 0: none did
};

/// Makes steps for about 0.3 s from `state`. The fastest batch counts: others on the machine only
/// slow it.
Probe probe(const Model& model, State state);

}  // namespace tt
