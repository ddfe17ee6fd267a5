#include "simulation/drive.hpp"

#include <numbers>

namespace tt {

void hold_flow(const Model& model, State& state) {
    if (!drive_looks_at(model, state.step)) return;
    DriveState& drive = state.drive;
    // The mean flow answers a force g as U' = g − U/T with T = H²/(π² ν), the slowest viscous mode.
    // The gains 3/T and 4/T² of this proportional-integral controller put both poles of the loop at
    // −2/T: critically damped, no overshoot to a step.
    const Lattice& lattice = model.lattice;
    const double height = lattice.ny;
    const double response =
        height * height / (std::numbers::pi * std::numbers::pi * model.viscosity.plasma);
    const double sum =
        std::visit([](const auto& sites) { return sum_over_sites(sites.velocity.x); }, state.sites);
    const double mean = sum / (static_cast<double>(lattice.nx) * lattice.ny);
    const double sampled = model.undisturbed ? model.undisturbed->site_mean : 1.0;
    const double error = model.drive.target_velocity * sampled - mean;
    drive.integral += 4.0 * error * drive_interval / response;
    drive.body_force = model.drive.body_force + (3.0 * error + drive.integral) / response;
}

}  // namespace tt
