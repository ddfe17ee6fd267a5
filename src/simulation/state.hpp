#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "coupling/cut_stencils.hpp"
#include "coupling/stencil.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/moments.hpp"
#include "fluid/populations.hpp"
#include "fluid/relaxation.hpp"
#include "fluid/borders.hpp"
#include "interaction/contact.hpp"
#include "membrane/suspension.hpp"
#include "simulation/exits.hpp"
#include "simulation/feed.hpp"
#include "simulation/sections.hpp"

namespace tt {

/// What the sites hold, and how the nodes meet them, in one precision. All but the populations is
/// derived at every step.
template <class Real>
struct Sites {
    Populations<Real> populations;
    VectorField<Real> velocity;  ///< of the fluid; within a step at first the force on it
    Relaxation<Real> relaxation;
    Stencils<Real> stencils;
    Borders<Real> borders;  ///< walls of any shape, and ports
    CutStencils<Real> cut;  ///< of the nodes beside them

    Sites() = default;
    /// At rest; without nodes.
    explicit Sites(const Lattice& lattice)
        : populations(lattice), velocity(lattice), relaxation(lattice) {}
};
using SitesInPrecision = std::variant<Sites<double>, Sites<float>>;

inline SitesInPrecision sites_at_rest(const Lattice& lattice, Precision precision) {
    if (precision == Precision::fp32) return Sites<float>(lattice);
    return Sites<double>(lattice);
}

/// What the controller of the mean velocity remembers.
struct DriveState {
    double body_force = 0.0;  ///< acting now
    double integral = 0.0;
};

/// All that changes. A checkpoint holds step, populations, cells, drive, the contact counters, the
/// ports, who left, the feeds, what passed the sections and where the cytoplasm was last laid
/// (interior.x, y); the rest is derived.
struct State {
    std::int64_t step = 0;
    SitesInPrecision sites;
    Suspension cells;
    DriveState drive;
    ContactState contact;
    std::vector<PortFlow> ports;         ///< of the openings of the walls
    std::vector<Departed> departed;      ///< cells that left through them
    std::vector<FeedState> feeds;        ///< as Model::feeds
    std::vector<SectionState> sections;  ///< what passed those of the model

    InteriorState interior;  ///< derived from the above, but for the places kept in it

    /// Velocity and moments of one site: for tests and set-up.
    Vec2 velocity(int i, int j) const {
        return std::visit([&](const auto& s) { return s.velocity(i, j); }, sites);
    }
    Moments moments(int i, int j) const {
        return std::visit([&](const auto& s) { return tt::moments(s.populations, i, j); }, sites);
    }
};

/// A feed's own channel, and whom it leads.
struct FeedState {
    State state;
    std::vector<std::int32_t> turn;  ///< per cell of it: with which it comes to the port next
    std::vector<Follower> followers;
    std::vector<Entered> entered;  ///< cells that have come in, in time
};

}  // namespace tt
