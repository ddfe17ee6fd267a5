#include "verify/fluid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fluid/analytic.hpp"

namespace tt {
namespace {

/// max |u_x − exact(y)| / max |exact(y)| over all sites.
template <class Exact>
double profile_error(const Experiment& flow, Exact&& exact) {
    const Lattice& lattice = flow.model.lattice;
    double worst = 0.0, largest = 0.0;
    for (int j = 0; j < lattice.ny; ++j) {
        const double u = exact(Lattice::position(0, j).y);
        largest = std::max(largest, std::abs(u));
        for (int i = 0; i < lattice.nx; ++i)
            worst = std::max(worst, std::abs(flow.state.velocity(i, j).x - u));
    }
    return worst / largest;
}

/// Until the slowest shear wave between the walls, exp(−ν π² t/H²), has decayed by 40 powers of e;
/// at least 500 steps.
void come_to_rest(Experiment& flow, double slowest_viscosity) {
    const double wave_number = std::numbers::pi / flow.model.lattice.ny;
    flow.advance_by(
        500 + static_cast<std::int64_t>(40.0 / (slowest_viscosity * wave_number * wave_number)));
}

/// `velocity` gives that of site (i, j).
template <class Velocity>
double kinetic_energy(const Velocity& velocity, const Lattice& lattice) {
    double sum = 0.0;
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) sum += dot(velocity(i, j), velocity(i, j));
    }
    return sum;
}

}  // namespace

double poiseuille_error(int height, double viscosity, DrivenBy drive) {
    Model m = plain_model({4, height, true}, viscosity);
    const double force = 0.08 * viscosity / (height * height);  // peak velocity 0.01
    if (drive == DrivenBy::body_force)
        m.drive.body_force = force;
    else
        m.boundaries.pressure_drop = force * m.lattice.nx;
    Experiment flow(m, {});
    come_to_rest(flow, viscosity);
    return profile_error(
        flow, [&](double y) { return analytic::poiseuille(y, height, viscosity, force); });
}

double two_layer_couette_error() {
    constexpr int height = 12;
    constexpr double interface = 5.0, speed = 0.04;
    Model m = plain_model({4, height, true}, 0.5);
    m.viscosity.layer_viscosity = 0.1;
    m.viscosity.layer_thickness = interface;
    m.boundaries.top_speed = speed;
    Experiment flow(m, {});
    come_to_rest(flow, 0.1);
    return profile_error(flow, [&](double y) {
        return analytic::couette(y, {double(height), interface, 0.1, 0.5}, speed);
    });
}

double taylor_green_energy(int size) {
    constexpr double viscosity = 0.1;
    const Model m = plain_model({size, size, false}, viscosity);
    const double wave = 2.0 * std::numbers::pi / size;
    VectorField start(m.lattice);
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const Vec2 u = analytic::taylor_green(Lattice::position(i, j), {wave, wave},
                                                  0.32 / size, viscosity, 0.0);
            start.x(i, j) = u.x;
            start.y(i, j) = u.y;
        }
    }
    Experiment vortices(m, {}, start);
    // The velocity decays at the rate 2 ν w²; a pass leaves the velocity of its start.
    const auto steps = static_cast<std::int64_t>(std::lround(0.5 / (viscosity * wave * wave)));
    vortices.advance_by(steps + 1);
    const auto now = [&](int i, int j) { return vortices.state.velocity(i, j); };
    const double left = kinetic_energy(now, m.lattice) / kinetic_energy(start, m.lattice);
    const double exact = std::exp(-4.0 * viscosity * wave * wave * static_cast<double>(steps));
    return left / exact * std::exp(-2.0);
}

}  // namespace tt
