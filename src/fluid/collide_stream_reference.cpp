#include <algorithm>
#include <array>
#include <vector>

#include "fluid/collide_stream.hpp"

namespace tt {
namespace {

using Nine = std::array<double, d2q9::count>;

/// The populations arriving at site (x, y), in either phase, without a halo.
template <class Real>
Nine arriving_at(const Populations<Real>& populations, int x, int y) {
    const Lattice& lattice = populations.lattice();
    Nine f{};
    for (int i = 0; i < d2q9::count; ++i) {
        const bool home =
            populations.phase == Phase::even || populations.wall_between(y, -d2q9::cy[i]);
        f[i] = home ? populations.slot(i, x, y)
                    : populations.slot(d2q9::opposite[i], wrapped(x - d2q9::cx[i], lattice.nx),
                                       wrapped(y - d2q9::cy[i], lattice.ny));
    }
    return f;
}

/// Eqs. 1–4 with two rates, where a_i^± = ½(a_i ± a_ī):
///
///     g_i = f_i − ω⁺ (f_i⁺ − f_i^eq⁺) − ω⁻ (f_i⁻ − f_i^eq⁻) + (1 − ω⁺/2) B_i⁺ + (1 − ω⁻/2) B_i⁻.
///
/// Returns g and sets u.
template <class AnEquilibrium>
Nine collided(AnEquilibrium kind, const Nine& f, Vec2 force, double even, double odd, Vec2& u) {
    double density_deviation = 0.0;
    Vec2 momentum = 0.5 * force;
    for (int i = 0; i < d2q9::count; ++i) {
        density_deviation += f[i];
        momentum += f[i] * Vec2{double(d2q9::cx[i]), double(d2q9::cy[i])};
    }
    u = velocity(kind, density_deviation, momentum);
    Nine off_equilibrium{};
    Nine push{};
    for (int i = 0; i < d2q9::count; ++i) {
        off_equilibrium[i] = f[i] - population(kind, i, density_deviation, u);
        push[i] = forcing(kind, i, u, force);
    }
    Nine g{};
    for (int i = 0; i < d2q9::count; ++i) {
        const int o = d2q9::opposite[i];
        g[i] = f[i] - even * 0.5 * (off_equilibrium[i] + off_equilibrium[o]) -
               odd * 0.5 * (off_equilibrium[i] - off_equilibrium[o]) +
               (1.0 - 0.5 * even) * 0.5 * (push[i] + push[o]) +
               (1.0 - 0.5 * odd) * 0.5 * (push[i] - push[o]);
    }
    return g;
}

/// What departs from each site.
using Departures = std::vector<Nine>;

/// Sends g away from site (x, y) into `next`, phase even: to the neighbour, through a periodic end,
/// or half-way back from a wall of the lattice. What goes to a closed site is left to the links.
template <class Real>
void stream(const Boundaries& boundaries, const Nine& g, int x, int y, Populations<Real>& next) {
    const Lattice& lattice = next.lattice();
    for (int i = 0; i < d2q9::count; ++i) {
        const int to_x = x + d2q9::cx[i];
        const int to_y = y + d2q9::cy[i];
        if (next.wall_between(y, d2q9::cy[i])) {
            const double wall_speed = to_y < 0 ? boundaries.bottom_speed : boundaries.top_speed;
            next.set_slot(d2q9::opposite[i], x, y,
                          g[i] - 6.0 * d2q9::weight[i] * along(i, {wall_speed, 0.0}));
            continue;
        }
        double gain = 0.0;
        if (to_x == lattice.nx) gain = d2q9::weight[i] * 3.0 * boundaries.pressure_drop;
        if (to_x == -1) gain = -d2q9::weight[i] * 3.0 * boundaries.pressure_drop;
        next.set_slot(i, wrapped(to_x, lattice.nx), wrapped(to_y, lattice.ny), g[i] + gain);
    }
}

/// What comes back along the links of walls of any shape (fluid/wall_links.hpp).
template <class Real>
void return_from_walls(const Walls& walls, const Departures& g, Populations<Real>& next) {
    const Lattice& lattice = walls.lattice;
    const auto at = [&](int x, int y) -> const Nine& {
        return g[static_cast<std::size_t>(lattice.row_in_box(y)) * lattice.nx +
                 wrapped(x, lattice.nx)];
    };
    std::vector<double> returned, excess, weight;
    for (const WallLink& link : walls.links) {
        const int i = link.direction, o = d2q9::opposite[i];
        const double q = link.second ? link.q : 0.5;
        double gain = 4.0 / (1.0 + 2.0 * q) * 3.0 * d2q9::weight[i] * along(i, link.velocity);
        if (link.second)
            gain += (1.0 - 2.0 * q) / (1.0 + 2.0 * q) *
                    (at(link.i + d2q9::cx[i], link.j + d2q9::cy[i])[o] - at(link.i, link.j)[i]);
        returned.push_back(at(link.i, link.j)[o] + gain);
        const auto loops = static_cast<std::size_t>(link.loop) + 1;
        excess.resize(std::max(excess.size(), loops), 0.0);
        weight.resize(std::max(weight.size(), loops), 0.0);
        excess[link.loop] += gain;
        weight[link.loop] += d2q9::weight[i];
    }
    for (std::size_t l = 0; l < walls.links.size(); ++l) {
        const WallLink& link = walls.links[l];
        const int i = link.direction;
        next.set_slot(i, link.i, link.j,
                      returned[l] - d2q9::weight[i] * excess[link.loop] / weight[link.loop]);
    }
}

/// What comes in through ports (fluid/ports.hpp).
template <class Real>
void enter_through_ports(const Walls& walls, const Equilibrium& equilibrium,
                         const std::vector<PortCondition>& conditions, const Departures& g,
                         const VectorField<Real>& velocity, Populations<Real>& next) {
    const Lattice& lattice = walls.lattice;
    const bool inertia = !std::holds_alternative<LinearEquilibrium>(equilibrium);
    for (std::size_t n = 0; n < walls.openings.size(); ++n) {
        const bool across_x = walls.openings[n].out_x != 0;
        double inflow = 0.0, weight = 0.0;  // as if the density were held at 0
        std::vector<double> entering;
        for (const OpeningLink& link : walls.inflow) {
            if (link.opening != static_cast<int>(n)) continue;
            const int i = link.direction, m = across_x ? d2q9::mirrored_x[i] : d2q9::mirrored_y[i];
            const int x = link.i - (across_x ? 0 : d2q9::cx[i]);
            const int y = link.j - (across_x ? d2q9::cy[i] : 0);
            const double gone = g[static_cast<std::size_t>(lattice.row_in_box(y)) * lattice.nx +
                                  wrapped(x, lattice.nx)][m];
            const Vec2 u{velocity.x(link.i, link.j), velocity.y(link.i, link.j)};
            const double across = across_x ? u.x : u.y;
            entering.push_back(-gone + (inertia ? 6.0 * d2q9::weight[i] * across * across : 0.0));
            inflow += entering.back() - gone;
            weight += d2q9::weight[i];
        }
        const auto* held = std::get_if<HeldInflow>(&conditions[n]);
        const double density = held ? (held->rate - inflow) / (2.0 * weight)
                                    : std::get<HeldDensity>(conditions[n]).deviation;
        auto next_entering = entering.begin();
        for (const OpeningLink& link : walls.inflow) {
            if (link.opening != static_cast<int>(n)) continue;
            next.set_slot(link.direction, link.i, link.j,
                          *next_entering++ + 2.0 * d2q9::weight[link.direction] * density);
        }
    }
}

}  // namespace

template <class Real>
void collide_and_stream_reference(const Equilibrium& equilibrium, const Boundaries& boundaries,
                                  Vec2 body_force, const VectorField<Real>& force,
                                  const Relaxation<Real>& relaxation,
                                  Populations<Real>& populations, VectorField<Real>& velocity) {
    const Lattice& lattice = populations.lattice();
    const Walls* const walls = boundaries.walls.get();
    Populations<Real> next(lattice);
    Departures departures;
    for (int y = 0; y < lattice.ny; ++y) {
        for (int x = 0; x < lattice.nx; ++x) {
            departures.push_back({});
            if (walls && !walls->is_open(x, y)) continue;
            const Nine f = arriving_at(populations, x, y);
            Vec2 u;
            departures.back() = std::visit(
                [&](auto kind) {
                    return collided(kind, f, force(x, y) + body_force, relaxation.even(x, y),
                                    relaxation.odd(x, y), u);
                },
                equilibrium);
            velocity.x(x, y) = static_cast<Real>(u.x);
            velocity.y(x, y) = static_cast<Real>(u.y);
            stream(boundaries, departures.back(), x, y, next);
        }
    }
    if (walls) {
        return_from_walls(*walls, departures, next);
        enter_through_ports(*walls, equilibrium, boundaries.ports, departures, velocity, next);
    }
    populations = next;
}

template void collide_and_stream_reference(const Equilibrium&, const Boundaries&, Vec2,
                                           const VectorField<double>&, const Relaxation<double>&,
                                           Populations<double>&, VectorField<double>&);
template void collide_and_stream_reference(const Equilibrium&, const Boundaries&, Vec2,
                                           const VectorField<float>&, const Relaxation<float>&,
                                           Populations<float>&, VectorField<float>&);

}  // namespace tt
