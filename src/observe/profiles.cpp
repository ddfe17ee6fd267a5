#include "observe/profiles.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/outline.hpp"

namespace tt {

std::vector<double> hematocrit_profile(const Lattice& lattice, const Suspension& cells) {
    std::vector<double> profile(static_cast<std::size_t>(lattice.ny), 0.0);
    for (int c = 0; c < cells.cell_count(); ++c) {
        const Outline shape = outline(cells, c);
        const auto [low, high] = std::minmax_element(shape.y.begin(), shape.y.end());
        const int last = static_cast<int>(std::floor(*high - 0.5));
        for (int j = static_cast<int>(std::ceil(*low - 0.5)); j <= last; ++j) {
            const int row = lattice.walls ? j : wrapped(j, lattice.ny);
            if (row < 0 || row >= lattice.ny) continue;
            profile[row] += extent_at_height(shape, j + 0.5) / lattice.nx;
        }
    }
    return profile;
}

Profiles measure_profiles(const Model& model, const State& state) {
    Profiles profiles;
    for (int j = 0; j < model.lattice.ny; ++j) {
        const double* row = state.velocity.x.row(j);
        double sum = 0.0;
        for (int i = 0; i < model.lattice.nx; ++i) sum += row[i];
        profiles.velocity.push_back(model.scales.to_si<Velocity>(sum / model.lattice.nx).si);
    }
    profiles.hematocrit = hematocrit_profile(model.lattice, state.cells);
    return profiles;
}

}  // namespace tt
