#include "observe/membrane_stress.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "base/undefined.hpp"
#include "membrane/outline.hpp"

namespace tt {
namespace {

/// Of the samples from the membrane, along the normal [sites].
constexpr double first_distance = 3.0;
constexpr double second_distance = 5.0;

/// Whether all sites that FlowView::at reads are plasma, undisturbed by other cells.
bool can_sample(const Model& model, const PlasmaMap& plasma, Vec2 position, int cell) {
    const Lattice& lattice = model.lattice;
    const Walls* const walls = model.boundaries.walls.get();
    constexpr double reach = 2.2;  // of the farthest of them
    if (walls && walls->distance_at(position) < reach) return false;
    if (lattice.walls && (position.y < 0.5 || position.y > lattice.ny - 0.5)) return false;
    return plasma.clear_around(static_cast<int>(std::floor(position.x - 0.5)),
                               static_cast<int>(std::floor(position.y - 0.5)), cell);
}

/// t·(∇u + ∇uᵀ)·n with t = n turned left.
double tangential_shear_rate(const VelocityGradient& g, Vec2 n) {
    const double twice_shear = g.by_x.y + g.by_y.x;
    return 2.0 * n.x * n.y * (g.by_y.y - g.by_x.x) + (n.x * n.x - n.y * n.y) * twice_shear;
}

template <class Real>
MembraneStress stress_on(const Outline& shape, const Model& model, const Sites<Real>& sites,
                         const PlasmaMap& plasma, int cell) {
    const Lattice& lattice = model.lattice;
    const FlowView flow(sites.velocity, model.boundaries);
    const auto shear_rate = [&](int node, double distance) -> std::optional<double> {
        const Vec2 n = outward_normal(shape, node);
        const Vec2 position = shape[node] + distance * n;
        if (!can_sample(model, plasma, position, cell)) return std::nullopt;
        return tangential_shear_rate(flow.at(position), n);
    };
    double traction = -1.0, principal = 0.0;
    for (int k = 0; k < shape.size(); ++k) {
        if (const auto first = shear_rate(k, first_distance)) {
            const double slope_base = second_distance - first_distance;
            const double second = shear_rate(k, second_distance).value_or(*first);
            const double at_membrane =
                (second_distance * *first - first_distance * second) / slope_base;
            traction = std::max(traction, model.viscosity.plasma * std::abs(at_membrane));
        }
        const int i = flow.column(static_cast<int>(std::floor(shape.x[k])));
        const int row = flow.row(static_cast<int>(std::floor(shape.y[k])));
        const int j = std::clamp(row, 0, lattice.ny - 1);
        const double rate = principal_shear_rate(flow.at_site(i, j));
        principal = std::max(principal, local_viscosity(sites.relaxation, i, j) * rate);
    }
    if (traction < 0.0) traction = undefined;
    return {traction, principal};
}

}  // namespace

MembraneStress membrane_stress(const Model& model, const State& state, const PlasmaMap& plasma,
                               int cell) {
    const Outline shape = outline(state.cells, cell);
    return std::visit(
        [&](const auto& sites) { return stress_on(shape, model, sites, plasma, cell); },
        state.sites);
}

}  // namespace tt
