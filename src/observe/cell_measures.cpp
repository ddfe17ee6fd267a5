#include "observe/cell_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "base/parallel.hpp"
#include "base/undefined.hpp"
#include "observe/membrane_stress.hpp"

namespace tt {
namespace {

std::span<const double> of_cell(const std::vector<double>& values, const Suspension& cells,
                                int cell) {
    return std::span(values).subspan(static_cast<std::size_t>(cells.first[cell]),
                                     static_cast<std::size_t>(cells.node_count(cell)));
}

/// Mean over the nodes of their angular velocity about the centroid.
double turning_rate(const Outline& outline, std::span<const double> ux, std::span<const double> uy,
                    Vec2 centre, Vec2 drift) {
    double sum = 0.0;
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 arm = outline[k] - centre;
        sum += cross(arm, Vec2{ux[k], uy[k]} - drift) / dot(arm, arm);
    }
    return sum / outline.size();
}

void measure_place(const Model& model, const State& state, int cell, const AreaMoments& moments,
                   CellMeasures& m) {
    const Suspension& cells = state.cells;
    const Outline shape = outline(cells, cell);
    const auto ux = of_cell(cells.ux, cells, cell), uy = of_cell(cells.uy, cells, cell);
    const Vec2 centroid = moments.centroid, velocity = centroid_velocity(shape, ux, uy);
    const Scales& scales = model.scales;
    m.x = scales.to_si<Length>(centroid.x + model.origin.x);
    m.y = scales.to_si<Length>(centroid.y + model.origin.y);
    m.velocity = scales.to_si<Velocity>(velocity.x);
    m.phase_rate = scales.to_si<Rate>(turning_rate(shape, ux, uy, centroid, velocity));
    m.wall_distance.si = undefined;
    if (const Walls* walls = model.boundaries.walls.get()) {
        double nearest = HUGE_VAL;
        for (int k = 0; k < shape.size(); ++k)
            nearest = std::min(nearest, walls->distance_at(shape[k]));
        m.wall_distance = scales.to_si<Length>(nearest);
    } else if (model.lattice.walls) {
        const auto [low, high] = std::minmax_element(shape.y.begin(), shape.y.end());
        m.wall_distance = scales.to_si<Length>(std::min(*low, model.lattice.ny - *high));
    }
}

void measure_shape(const Scales& scales, const Suspension& cells, int cell,
                   const AreaMoments& moments, CellMeasures& m) {
    const Outline shape = outline(cells, cell);
    const EquivalentEllipse ellipse = equivalent_ellipse(moments);
    const RadiusRange radii = radius_range(shape, moments.centroid);
    const double length = perimeter(shape);
    m.area = scales.to_si<Area>(moments.area);
    m.area_error = moments.area / cells.reference_area[cell] - 1.0;
    m.perimeter = scales.to_si<Length>(length);
    m.lambda_C = length / cells.reference_perimeter[cell];
    m.strain = m.lambda_C - 1.0;
    m.taylor_inertia = taylor_deformation(ellipse.major, ellipse.minor);
    m.taylor_extent = taylor_deformation(radii.largest, radii.smallest);
    constexpr double rounding = 1e-9;  // of a circle, which has no long axis
    m.inclination_deg =
        m.taylor_inertia > rounding ? ellipse.inclination * 180.0 / std::numbers::pi : undefined;
}

void measure_stretch(const Suspension& cells, int cell, CellMeasures& m) {
    const Outline shape = outline(cells, cell);
    const auto rest = of_cell(cells.rest_length, cells, cell);
    m.stretch_min = std::numeric_limits<double>::infinity();
    m.stretch_max = 0.0;
    for (int k = 0; k < shape.size(); ++k) {
        const Vec2 end = shape[k + 1 == shape.size() ? 0 : k + 1];
        const double stretch = norm(end - shape[k]) / rest[k];
        m.stretch_min = std::min(m.stretch_min, stretch);
        m.stretch_max = std::max(m.stretch_max, stretch);
    }
}

/// Eq. 24, G* = τ_max L_C / E_s, with E_s the shear modulus of the in-plane law as it stands in Eq.
/// 10 (small-strain slope 3 E_s). A pure number, so lattice units serve.
void measure_stress(const Model& model, const State& state, const PlasmaMap& plasma, int cell,
                    CellMeasures& m) {
    const MembraneStress stress = membrane_stress(model, state, plasma, cell);
    const Membrane& membrane = model.kind_of(state.cells, cell).membrane;
    const double modulus =
        std::visit([](const auto& law) { return law.shear_modulus; }, membrane.in_plane);
    const double length = perimeter(outline(state.cells, cell));
    m.stress_traction = model.scales.to_si<Pressure>(stress.traction);
    m.stress_principal = model.scales.to_si<Pressure>(stress.principal);
    const double per_modulus = membrane.rigid ? undefined : length / modulus;
    m.shear_number_star_traction = stress.traction * per_modulus;
    m.shear_number_star_principal = stress.principal * per_modulus;
}

}  // namespace

double tank_treading_rate(const Outline& outline, std::span<const double> ux,
                          std::span<const double> uy) {
    return turning_rate(outline, ux, uy, area_moments(outline).centroid,
                        centroid_velocity(outline, ux, uy));
}

CellMeasures measure_cell(const Model& model, const State& state, const PlasmaMap& plasma,
                          int cell) {
    CellMeasures m;
    m.time = Time{static_cast<double>(state.step) * model.scales.time};
    m.cell = state.cells.id[cell];
    m.kind = state.cells.kind[cell];
    const AreaMoments moments = area_moments(outline(state.cells, cell));
    measure_place(model, state, cell, moments, m);
    measure_shape(model.scales, state.cells, cell, moments, m);
    measure_stretch(state.cells, cell, m);
    const SharpestBend bend = sharpest_bend(outline(state.cells, cell));
    m.turn_max_deg = bend.turn * 180.0 / std::numbers::pi;
    m.curvature_radius_sites = bend.radius;
    measure_stress(model, state, plasma, cell, m);
    m.dissipation = model.scales.to_si<Power>(viscous_dissipation(
        model.kind_of(state.cells, cell).membrane.viscosity, state.cells, cell));
    return m;
}

CellMeasures measure_cell(const Model& model, const State& state, int cell) {
    return measure_cell(model, state, PlasmaMap(model.lattice, state.cells), cell);
}

std::vector<CellMeasures> measure_cells(const Model& model, const State& state) {
    PlasmaMap plasma(model.lattice);
    std::vector<CellMeasures> all(static_cast<std::size_t>(state.cells.cell_count()));
    with_team(model.threads, [&] {
        plasma.mark(state.cells);
        team_barrier();
        const auto [begin, end] = own_cells(state.cells);
        for (int c = begin; c < end; ++c) all[c] = measure_cell(model, state, plasma, c);
    });
    return all;
}

}  // namespace tt
