#pragma once

#include <variant>
#include <vector>

#include "base/parallel.hpp"
#include "fluid/boundaries.hpp"
#include "fluid/equilibrium.hpp"
#include "fluid/ports.hpp"
#include "fluid/wall_links.hpp"

namespace tt {

/// What answers a pass of `collide_and_stream` where the walls are of any shape: their links, and
/// the ports in them. Nothing in a straight channel.
template <class Real = double>
struct Borders {
    WallLinks<Real> links;
    Ports<Real> ports;

    Borders() = default;
    Borders(const Walls& walls, const Populations<Real>& populations)
        : links(walls, populations), ports(walls, populations) {}

    /// After a pass, whose velocity is `velocity`, in the phase that the populations still have.
    /// False if there was nothing to do. Team function, as WallLinks::apply.
    bool apply(const Equilibrium& equilibrium, const Boundaries& boundaries,
               const VectorField<Real>& velocity, const FeedPopulations<Real>& feeds,
               Populations<Real>& populations, std::vector<PortFlow>& flow) {
        if (links.empty()) return false;
        links.apply(populations);
        const bool inertia = !std::holds_alternative<LinearEquilibrium>(equilibrium);
        if (team_rank() == 0)
            ports.apply(boundaries.ports, inertia ? &velocity : nullptr, feeds, populations, flow);
        return true;
    }
};

}  // namespace tt
