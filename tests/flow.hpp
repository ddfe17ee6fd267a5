#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/borders.hpp"

namespace tt {

/// A fluid without cells, for tests: everything a pass needs, with uniform viscosity 1/6 and
/// nothing acting.
struct Flow {
    Lattice lattice;
    Equilibrium equilibrium = LinearEquilibrium{};
    Collision collision = Trt{};
    Boundaries boundaries;
    Vec2 body_force;
    VectorField<> force{lattice};
    VectorField<> velocity{lattice};
    Relaxation<> relaxation{lattice};
    Populations<> populations{lattice};
    std::vector<PortFlow> ports;  ///< of the last two steps
    double slowest_viscosity = 1.0 / 6.0;

    explicit Flow(const Lattice& l) : lattice(l) {
        set_viscosity([](int) { return 1.0 / 6.0; });
    }

    /// Kinematic viscosity of each row.
    template <class F>
    void set_viscosity(F&& viscosity_of_row) {
        slowest_viscosity = 1e300;
        for (int j = 0; j < lattice.ny; ++j) {
            const double viscosity = viscosity_of_row(j);
            const double even = even_rate(viscosity);
            const double odd = std::visit([&](auto c) { return c.odd_rate(even); }, collision);
            slowest_viscosity = std::min(slowest_viscosity, viscosity);
            for (int i = 0; i < lattice.nx; ++i) {
                relaxation.even(i, j) = even;
                relaxation.odd(i, j) = odd;
            }
        }
    }

    void run(long long steps) {
        Periodic exchange;
        Borders<> borders;
        if (boundaries.walls) borders = {*boundaries.walls, populations};
        ports.resize(boundaries.ports.size());
        for (long long step = 0; step < steps; ++step) {
            collide_and_stream(equilibrium, boundaries, body_force, force, relaxation, populations,
                               velocity);
            settle(exchange, populations, [&] {
                return borders.apply(equilibrium, boundaries, velocity, {}, populations, ports);
            });
        }
    }

    /// Until the slowest shear wave between the walls, exp(−ν π² t/H²), has decayed by 40 powers of
    /// e; at least 500 steps, in which a relaxation time of 10 decays as far.
    void run_to_rest() {
        const double wave_number = std::numbers::pi / lattice.ny;
        run(500 + static_cast<long long>(40.0 / (slowest_viscosity * wave_number * wave_number)));
    }
};

/// max |u_x − exact(y)| / max |exact(y)| over the column x = 0.
template <class F>
double profile_error(const Flow& flow, F&& exact) {
    double worst = 0.0;
    double largest = 0.0;
    for (int j = 0; j < flow.lattice.ny; ++j) {
        const double u = exact(Lattice::position(0, j).y);
        worst = std::max(worst, std::abs(flow.velocity.x(0, j) - u));
        largest = std::max(largest, std::abs(u));
    }
    return worst / largest;
}

/// Slope of log error against log size by the last two of a series of sizes that double.
inline double observed_order(const std::vector<double>& errors) {
    return std::log2(errors[errors.size() - 2] / errors.back());
}

}  // namespace tt
