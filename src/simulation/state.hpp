#pragma once

#include <cstdint>

#include "coupling/stencil.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/populations.hpp"
#include "fluid/relaxation.hpp"
#include "interaction/contact.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Where a step leaves the fluid's velocity for others to look at. Nothing else depends on it.
enum class FlowKept : std::uint8_t { everywhere, near_membranes };

/// What the controller of the mean velocity remembers.
struct DriveState {
    double body_force = 0.0;  ///< acting now
    double integral = 0.0;
};

/// All that changes. A checkpoint holds step, populations, cells, drive, the contact counters and
/// where the cytoplasm was last laid (interior.x, y); the rest is derived.
struct State {
    std::int64_t step = 0;
    Populations populations;
    Suspension cells;
    DriveState drive;
    ContactState contact;

    // Derived from the above at every step.
    VectorField force;     ///< on the fluid, by the membranes; see `advance` for what it ends as
    VectorField velocity;  ///< of the fluid, at the last step that kept it everywhere
    Relaxation relaxation;
    InteriorState interior;
    Stencils stencils;
};

}  // namespace tt
