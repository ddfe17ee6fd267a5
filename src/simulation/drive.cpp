#include "simulation/drive.hpp"

#include <cmath>
#include <numbers>

namespace tt {
namespace {

/// Mean over all sites of the velocity along the axis that the force goes along.
double mean_velocity(const Model& model, const State& state) {
    const Vec2 along = model.drive.direction;
    const bool upright = std::fabs(along.y) > std::fabs(along.x);
    const double sum = std::visit(
        [&](const auto& sites) {
            return sum_over_sites(upright ? sites.velocity.y : sites.velocity.x);
        },
        state.sites);
    const double sites = static_cast<double>(model.lattice.nx) * model.lattice.ny;
    return std::copysign(1.0, upright ? along.y : along.x) * sum / sites;
}

}  // namespace

void hold_flow(const Model& model, State& state) {
    if (!drive_looks_at(model, state.step)) return;
    DriveState& drive = state.drive;
    // The mean flow answers a force g as U' = g − U/T with T = H²/(π² ν), the slowest viscous mode.
    // The gains 3/T and 4/T² of this proportional-integral controller put both poles of the loop at
    // −2/T: critically damped, no overshoot to a step.
    const double height = model.drive.width > 0.0 ? model.drive.width : model.lattice.ny;
    const double response =
        height * height / (std::numbers::pi * std::numbers::pi * model.viscosity.plasma);
    const double sampled = model.undisturbed ? model.undisturbed->site_mean : 1.0;
    const double error = model.drive.target_velocity * sampled - mean_velocity(model, state);
    drive.integral += 4.0 * error * drive_interval / response;
    drive.body_force = model.drive.body_force + (3.0 * error + drive.integral) / response;
}

void follow_waves(const Model& model, State& state) {
    const auto now = static_cast<double>(state.step);
    const Drive& drive = model.drive;
    if (!drive.waveform.steady())
        state.drive.body_force = drive.body_force * drive.waveform.at(now);
    // What comes in through ports is there at the end of the step.
    for (std::size_t n = 0; n < model.port_waves.size(); ++n)
        state.ports[n].factor = model.port_waves[n].at(now + 1.0);
}

}  // namespace tt
