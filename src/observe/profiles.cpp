#include "observe/profiles.hpp"

#include <variant>

#include "membrane/outline.hpp"

namespace tt {

std::vector<double> hematocrit_profile(const Lattice& lattice, const Suspension& cells) {
    std::vector<double> profile(static_cast<std::size_t>(lattice.ny), 0.0);
    for (int c = 0; c < cells.cell_count(); ++c) {
        for (const RowCrossing& crossing : row_crossings(outline(cells, c))) {
            const int row = lattice.row_in_box(crossing.row);
            if (row >= 0 && row < lattice.ny) profile[row] += crossing.turn * crossing.x;
        }
    }
    for (double& share : profile) share /= lattice.nx;
    return profile;
}

Profiles measure_profiles(const Model& model, const State& state) {
    Profiles profiles;
    for (int j = 0; j < model.lattice.ny; ++j) {
        const double sum = std::visit(
            [j](const auto& sites) { return sum_of_row(sites.velocity.x, j); }, state.sites);
        const double mean = sum / model.lattice.nx;
        profiles.velocity.push_back(model.scales.to_si<Velocity>(mean).si);
    }
    profiles.hematocrit = hematocrit_profile(model.lattice, state.cells);
    return profiles;
}

}  // namespace tt
