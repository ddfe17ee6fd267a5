#include "simulation/advance.hpp"

#include "base/isa.hpp"
#include "base/parallel.hpp"
#include "fluid/collide_stream.hpp"
#include "membrane/area.hpp"
#include "membrane/implicit_tension.hpp"
#include "membrane/node_mobility.hpp"
#include "membrane/rigid.hpp"
#include "simulation/drive.hpp"

namespace tt {
namespace {

/// Nodes move with the mean of the velocities sampled in this step and the last. Besides its
/// momentum a lattice fluid conserves (−1)^{x+t} u, which changes sign from step to step: the mean
/// does not see it, and so cannot feed it (docs/theory/interface.md).
TT_CLONES void average_in_time(double* u, double* last, int count, bool first_step) {
#pragma omp simd
    for (int n = 0; n < count; ++n) {
        const double now = u[n];
        u[n] = first_step ? now : 0.5 * (now + last[n]);
        last[n] = now;
    }
}

void average_in_time(Suspension& cells, int cell, bool first_step) {
    const int first = cells.first[cell], count = cells.node_count(cell);
    average_in_time(&cells.ux[first], &cells.ux_sampled[first], count, first_step);
    average_in_time(&cells.uy[first], &cells.uy_sampled[first], count, first_step);
}

/// Forward Euler along one axis.
TT_CLONES void move(const double* u, int count, double* x) {
#pragma omp simd
    for (int n = 0; n < count; ++n) x[n] += u[n];
}

void move_nodes(Suspension& cells, int cell) {
    const int first = cells.first[cell], count = cells.node_count(cell);
    move(&cells.ux[first], count, &cells.x[first]);
    move(&cells.uy[first], count, &cells.y[first]);
}

template <class Real>
void advance(const Model& m, Sites<Real>& sites, State& s, Exchange& x, StepTimes* times,
             Health* health) {
    const bool first_step = s.step == 0;
    // One field for both: the collision, the last to read the force on a site, puts the velocity in
    // its place. So much less to bring into the cache.
    VectorField<Real>&force = sites.velocity, &velocity = sites.velocity;
    const Walls* const walls = m.boundaries.walls.get();
    const Order order = m.has_dipoles() ? Order::first : Order::zeroth;
    const auto kind_of = [&m, &s](int cell) -> const CellKind& { return m.kind_of(s.cells, cell); };
    const FeedPopulations<Real> feeds = [&s](int n) -> const Populations<Real>& {
        return std::get<Sites<Real>>(s.feeds[n].state.sites).populations;
    };
    const auto done = [times](Pass pass) {
        if (times) times->lap(pass);
    };
    for (std::size_t n = 0; n < s.feeds.size(); ++n)
        advance(*m.feeds[n].channel, s.feeds[n].state, x, times,
                health ? health->of_feed(n) : nullptr);
    if (times) times->start();

    // Each thread its share of the cells …
    for_own_cells(s.cells, [&](int cell) {  // Eqs. 10–15
        const Membrane& membrane = kind_of(cell).membrane;
        if (membrane.rigid) return set_rigid_forces(s.cells, cell);
        set_membrane_forces(membrane, s.cells, cell);
        if (membrane.viscosity)
            add_viscous_forces(membrane.viscosity, m.viscosity.plasma, s.cells, cell);
    });
    done(Pass::membrane);

    add_pair_forces(m.contact, m.lattice, s.step, s.cells, s.contact);  // Eqs. 16–17
    if (!m.exits.empty()) fade_forces(m, s.cells);
    done(Pass::contact);

    locate(m.delta, m.lattice, s.cells, sites.stencils);  // Eq. 8
    if (walls) cut_at_walls(*walls, s.cells, sites.stencils, sites.cut);
    if (order == Order::first)
        for_own_cells(s.cells, [&](int cell) { set_dipoles(kind_of(cell).jump, s.cells, cell); });
    if (walls) weaken_dipoles(sites.cut, s.cells);
    if (!s.feeds.empty()) take_loads(m, s, sites);
    done(Pass::locate);

    lay_cytoplasm(m.viscosity, s.cells, s.interior);
    done(Pass::viscosity);

    // … then of the rows of sites …
    clear(force);
    spread(order, sites.stencils, s.cells, force);  // Eq. 9
    if (walls) spread_cut(order, sites.cut, s.cells, force);
    x.fold(force);
    done(Pass::spread);

    update_viscosity(m.viscosity, s.cells, s.interior, sites.relaxation);
    done(Pass::viscosity);

    collide_and_stream(m.equilibrium, m.boundaries, s.drive.body_force * m.drive.direction, force,
                       sites.relaxation, sites.populations, velocity);  // Eqs. 1–4
    x.fill(velocity);
    settle(x, sites.populations, [&] {  // waits until all velocities are there
        return sites.borders.apply(m.equilibrium, m.boundaries, velocity, feeds, sites.populations,
                                   s.ports);
    });
    done(Pass::fluid);

    // … and of the cells again.
    for_own_cells(s.cells, [&](int cell) {
        const CellKind& kind = kind_of(cell);
        const Membrane& membrane = kind.membrane;
        if (const Leader leader = leader_of(m, s, cell)) return follow(leader, s.cells, cell);
        interpolate(order, sites.stencils, velocity, s.cells, cell);  // Eq. 7
        if (walls) interpolate_cut(order, sites.cut, velocity, s.cells, cell);
        correct_velocities(kind.jump, s.cells, cell);
        if (walls) weaken_corrections(sites.cut, s.cells, cell);
        average_in_time(s.cells, cell, first_step);
        if (membrane.rigid) return move_rigidly(node_mobility(m.viscosity.plasma), s.cells, cell);
        if (membrane.mobility > 0.0) answer_with_tension(membrane.mobility, s.cells, cell);
        if (membrane.hold_area) hold_area(s.cells, cell);
        move_nodes(s.cells, cell);
    });
    done(Pass::move);
    if (health) {
        health->watch_nodes(m, s.cells);
        if (times) times->start();  // a check, no part of the step
    }
    on_one_thread([&] {
        hold_flow(m, s);
        ++s.step;
        follow_waves(m, s);
    });
    done(Pass::move);
}

}  // namespace

void advance(const Model& m, State& s, Exchange& x, StepTimes* times, Health* health) {
    std::visit([&](auto& sites) { advance(m, sites, s, x, times, health); }, s.sites);
}

}  // namespace tt
