#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "exchange/exchange.hpp"
#include "simulation/health.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// A change of the numerics that may keep a run from blowing up.
struct Remedy {
    std::string settings;  ///< as on a command line: `--set numerics.dt="0.5 us"`
    Model model;           ///< with it
};

/// What to write, `settings` as in a Remedy or empty, and what is known of it.
struct Suggestion {
    std::string settings, words;
    std::string text() const { return settings.empty() ? words : settings + " (" + words + ")"; }
};

/// What a run that blew up was: its model, its last good state, and what was seen.
struct BlowUp {
    const Model& model;
    const State& good;
    const Instability& what;
};

/// Goes on from the last good state with each remedy in turn, in memory, until one gets well past
/// the failure: six times as far from the good state, and 2000 steps. Says in words what to write:
/// the settings of that one, or that none of them did so. A minute of the clock at most, less if
/// the run is asked to stop.
Suggestion tried_suggestion(const std::vector<Remedy>& remedies, const BlowUp& blow_up,
                            const HealthLimits& limits, Exchange& exchange);

}  // namespace tt
