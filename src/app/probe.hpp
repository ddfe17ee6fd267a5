#pragma once

#include <optional>

#include "base/error.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// How fast the steps of a run are, and what memory it takes.
struct Probe {
    double steps_per_second = 0.0;  ///< 0: not tried
    double memory_bytes = 0.0;      ///< most that this process has held
    int threads = 1;
    std::optional<Instability> instability;  ///< what went wrong meanwhile
};

/// Makes steps for about 0.3 s from `state`. The fastest batch counts: others on the machine only
/// slow it.
Probe probe(const Model& model, State state);

}  // namespace tt
