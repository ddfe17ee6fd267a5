#include "simulation/undisturbed.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/wall_links.hpp"

namespace tt {
namespace {

constexpr double force = 1e-6;
constexpr double viscosity = 0.5;  // τ = 2: momentum spreads fast, pressure not too slowly

/// Fluid and walls, at rest at first.
struct Settling {
    Boundaries boundaries;
    VectorField<> no_force, velocity;
    Relaxation<> relaxation;
    Populations<> populations;
    WallLinks<> links;
    Periodic exchange;

    explicit Settling(const Walls& walls)
        : no_force(walls.lattice),
          velocity(walls.lattice),
          relaxation(walls.lattice),
          populations(walls.lattice),
          links(walls, populations) {
        boundaries.walls = std::shared_ptr<const Walls>(std::shared_ptr<void>(), &walls);
        const Rates rates = Trt{}.rates(viscosity);
        relaxation.even.fill(rates.even);
        relaxation.odd.fill(rates.odd);
    }
    void step() {
        collide_and_stream(LinearEquilibrium{}, boundaries, {force, 0.0}, no_force, relaxation,
                           populations, velocity);
        settle(exchange, links, populations);
        team_barrier();
    }
};

double mean_velocity(const Settling& flow) {
    const Lattice& lattice = flow.velocity.x.lattice();
    return sum_over_sites(flow.velocity.x) / (static_cast<double>(lattice.nx) * lattice.ny);
}

/// Until what is left to come, by the pace at which changes get smaller, is a share of 10⁻⁵.
void run_until_steady(Settling& flow, int threads) {
    constexpr int steps = 250, most = 4000;
    double mean = 0.0, change = HUGE_VAL;
    for (int n = 0; n < most; ++n) {
        with_team(threads, [&] {
            for (int k = 0; k < steps; ++k) flow.step();
        });
        const double now = mean_velocity(flow), before = std::exchange(change, now - mean);
        mean = now;
        const double pace = std::fabs(change / before);
        const double left = pace < 1.0 ? std::fabs(change) * pace / (1.0 - pace) : HUGE_VAL;
        if (n > 2 && left < 1e-5 * std::fabs(mean)) return;
    }
}

/// What columns of sites leave out or count twice beside a wall at the share q of the last spacing,
/// of a velocity that grows linearly from it: u′((q − ½)²/2 − 1/24).
double beside_walls(const Walls& walls, const Field<>& u) {
    double sum = 0.0;
    for (const WallLink& link : walls.links) {
        if (d2q9::cx[link.direction] != 0) continue;
        const double q = std::max(link.q, 1e-3), off = q - 0.5;
        sum += u(link.i, link.j) / q * (0.5 * off * off - 1.0 / 24.0);
    }
    if (!walls.lattice.walls) return sum;
    for (const int j : {0, walls.lattice.ny - 1})
        for (int i = 0; i < walls.lattice.nx; ++i) sum -= 2.0 * u(i, j) / 24.0;
    return sum;
}

void measure(const Walls& walls, UndisturbedFlow& flow) {
    const VectorField<>& u = flow.velocity;
    for (int j = 0; j < walls.lattice.ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i)
            flow.fastest = std::max(flow.fastest, norm(u(i, j)));
    const auto rate = [&](int i, int j, bool upright, double q) {
        const double along = upright ? u.x(i, j) : u.y(i, j);
        flow.steepest = std::max(flow.steepest, std::fabs(along) / std::max(q, 0.3));
    };
    for (const WallLink& link : walls.links) {
        const int k = link.direction;
        if (k < 5) rate(link.i, link.j, d2q9::cx[k] == 0, link.q);
    }
    if (!walls.lattice.walls) return;
    for (int i = 0; i < walls.lattice.nx; ++i)
        for (const int j : {0, walls.lattice.ny - 1}) rate(i, j, true, 0.5);
}

}  // namespace


UndisturbedFlow undisturbed_flow(const Walls& walls, int threads) {
    const Lattice& lattice = walls.lattice;
    Settling settling(walls);
    run_until_steady(settling, threads);
    UndisturbedFlow flow;
    flow.velocity = VectorField<>(lattice);
    flow.density = Field<>(lattice);
    for (int step = 0; step < 2; ++step) {
        settling.step();
        for (int j = 0; j < lattice.ny; ++j) {
            const std::vector<double> density = density_deviations(settling.populations, j);
            for (int i = 0; i < lattice.nx; ++i) {
                if (!walls.is_open(i, j)) continue;
                flow.velocity.x(i, j) += 0.5 * settling.velocity.x(i, j);
                flow.velocity.y(i, j) += 0.5 * settling.velocity.y(i, j);
                flow.density(i, j) += 0.5 * density[i];
            }
        }
    }
    const double rate =
        (sum_over_sites(flow.velocity.x) + beside_walls(walls, flow.velocity.x)) / lattice.nx;
    flow.conductance = rate * viscosity / force;
    const double mean = rate / lattice.ny;
    for (std::size_t n = 0; n < flow.density.size(); ++n) {
        flow.velocity.x.data()[n] /= mean;
        flow.velocity.y.data()[n] /= mean;
        flow.density.data()[n] /= mean * viscosity;
    }
    measure(walls, flow);
    return flow;
}

}  // namespace tt
