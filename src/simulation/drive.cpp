#include "simulation/drive.hpp"

#include <numbers>

namespace tt {
namespace {

double mean_velocity(const Field& ux) {
    const Lattice& lattice = ux.lattice();
    double sum = 0.0;
    for (int j = 0; j < lattice.ny; ++j) {
        const double* const row = ux.row(j);
        double lane[8] = {};
        int i = 0;
        for (; i + 8 <= lattice.nx; i += 8) {
            for (int k = 0; k < 8; ++k) lane[k] += row[i + k];
        }
        for (; i < lattice.nx; ++i) lane[0] += row[i];
        for (const double part : lane) sum += part;
    }
    return sum / (static_cast<double>(lattice.nx) * lattice.ny);
}

}  // namespace

void hold_flow(const Model& model, State& state) {
    if (!drive_looks_at(model, state.step)) return;
    DriveState& drive = state.drive;
    // The mean flow answers a force g as U' = g − U/T with T = H²/(π² ν), the slowest viscous mode.
    // The gains 3/T and 4/T² of this proportional-integral controller put both poles of the loop at
    // −2/T: critically damped, no overshoot to a step.
    const double height = model.lattice.ny;
    const double response =
        height * height / (std::numbers::pi * std::numbers::pi * model.viscosity.plasma);
    const double error = model.drive.target_velocity - mean_velocity(state.velocity.x);
    drive.integral += 4.0 * error * drive_interval / response;
    drive.body_force = model.drive.body_force + (3.0 * error + drive.integral) / response;
}

}  // namespace tt
