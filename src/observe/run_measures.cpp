#include "observe/run_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "base/undefined.hpp"
#include "observe/cell_free_layer.hpp"
#include "observe/flow_gradient.hpp"
#include "observe/profiles.hpp"

namespace tt {
namespace {

bool walls_drive(const Model& model) {
    return model.lattice.walls && model.boundaries.bottom_speed != model.boundaries.top_speed;
}

/// Mean over columns of ν ∂u_x/∂y on each wall.
struct WallStress {
    double bottom = 0.0;
    double top = 0.0;
};
template <class Real>
WallStress stress_at_walls(const Model& model, const Sites<Real>& sites) {
    const FlowView flow(sites.velocity, model.boundaries);
    const auto [nx, ny] = std::pair{model.lattice.nx, model.lattice.ny};
    WallStress sum;
    for (int i = 0; i < nx; ++i) {
        sum.bottom += local_viscosity(sites.relaxation, i, 0) * flow.at_bottom_wall(i);
        sum.top += local_viscosity(sites.relaxation, i, ny - 1) * flow.at_top_wall(i);
    }
    return {sum.bottom / nx, sum.top / nx};
}

void measure_flow(const Model& model, const State& state, RunMeasures& m) {
    if (!model.port_names.empty()) {  // which way is along? ports.csv has what goes where
        m.flux.si = m.mean_velocity.si = m.pseudo_shear_rate.si = undefined;
        m.pressure_gradient.si = m.mu_app.si = m.mu_rel = undefined;
        m.wall_shear_stress.si = m.balance_shear_stress.si = undefined;
        return;
    }
    const Scales& scales = model.scales;
    const double width = model.lattice.ny;
    const double q = flux(model, state);
    const double gradient = driving_gradient(model, state);
    m.flux = scales.to_si<KinematicViscosity>(q);
    m.mean_velocity = scales.to_si<Velocity>(q / width);
    m.pseudo_shear_rate = scales.to_si<Rate>(q / (width * width));
    m.pressure_gradient = scales.to_si<PressureGradient>(gradient);
    double viscosity = undefined;
    if (model.boundaries.walls) {
        m.wall_shear_stress.si = m.balance_shear_stress.si = undefined;
        if (gradient != 0.0 && q != 0.0) viscosity = gradient * model.conductance() / q;
    } else if (model.lattice.walls) {
        const double stress = wall_shear_stress(model, state);
        m.wall_shear_stress = scales.to_si<Pressure>(stress);
        m.balance_shear_stress = scales.to_si<Pressure>(balance_shear_stress(model, state));
        const Boundaries& walls = model.boundaries;
        if (walls_drive(model)) {
            viscosity = stress * width / (walls.top_speed - walls.bottom_speed);
        } else if (gradient != 0.0 && q != 0.0) {
            viscosity = gradient * width * width * width / (12.0 * q);
        }
    } else {
        m.wall_shear_stress.si = m.balance_shear_stress.si = undefined;
    }
    m.mu_app = scales.to_si<Viscosity>(viscosity);
    m.mu_rel = viscosity / model.viscosity.plasma;
}

template <class Real>
TT_CLONES double largest_square(const Real* x, const Real* y, int count) {
    double largest = 0.0;
#pragma omp simd reduction(max : largest)
    for (int i = 0; i < count; ++i) {
        const double ux = x[i], uy = y[i];
        largest = greater(largest, ux * ux + uy * uy);
    }
    return largest;
}

template <class Real>
double largest_speed(const VectorField<Real>& velocity) {
    const Lattice& lattice = velocity.x.lattice();
    double square = 0.0;
    for (int j = 0; j < lattice.ny; ++j)
        square = std::max(square, largest_square(velocity.x.row(j), velocity.y.row(j), lattice.nx));
    return std::sqrt(square);
}

template <class Real>
double flux_of(const Model& model, const VectorField<Real>& velocity) {
    double sum = sum_over_sites(velocity.x);
    if (const Walls* walls = model.boundaries.walls.get()) {
        sum += flow_beside_walls(*walls, velocity.x);
    } else if (model.lattice.walls) {
        const FlowView flow(velocity, model.boundaries);
        for (int i = 0; i < model.lattice.nx; ++i) {
            sum += (flow.at_top_wall(i) - flow.at_bottom_wall(i)) / 24.0;
        }
    }
    return sum / model.lattice.nx;
}

/// Σ ν (∂u_x/∂y + ∂u_y/∂x) over the sites.
template <class Real>
double viscous_stress(const Model& model, const Sites<Real>& sites) {
    const FlowView flow(sites.velocity, model.boundaries);
    double sum = 0.0;
    for (int j = 0; j < model.lattice.ny; ++j) {
        for (int i = 0; i < model.lattice.nx; ++i) {
            const VelocityGradient g = flow.at_site(i, j);
            sum += local_viscosity(sites.relaxation, i, j) * (g.by_y.x + g.by_x.y);
        }
    }
    return sum;
}

/// Σ A / (length × width), and Σ A_c v_c / length over the flux.
void measure_hematocrit(const Model& model, std::span<const CellMeasures> cells, double fastest,
                        RunMeasures& m) {
    double area = 0.0, carried = 0.0;
    for (const CellMeasures& c : cells) {
        area += c.area.si;
        carried += c.area.si * c.velocity.si;
    }
    const double length = model.lattice.nx * model.scales.length;
    const double site = model.scales.length * model.scales.length;
    m.hematocrit_tube = area / (model.open_area() * site);
    // A mean of round-off, as in fluid at rest, carries nothing.
    const double round_off = 1e-9 * model.scales.to_si<Velocity>(fastest).si;
    const bool carries =
        model.shear_rate != 0.0 && !walls_drive(model) && std::abs(m.mean_velocity.si) > round_off;
    m.hematocrit_discharge = carries ? carried / length / m.flux.si : undefined;
}

/// Over the cells of which it is defined.
template <class Value>
double mean_over(std::span<const CellMeasures> cells, Value value) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const CellMeasures& c : cells) {
        if (!std::isfinite(value(c))) continue;
        sum += value(c);
        ++count;
    }
    return count == 0 ? undefined : sum / static_cast<double>(count);
}

void measure_shapes(const Model& model, std::span<const CellMeasures> cells, RunMeasures& m) {
    using C = CellMeasures;
    m.lambda_C = mean_over(cells, [](const C& c) { return c.lambda_C; });
    m.strain = m.lambda_C - 1.0;
    m.taylor_inertia = mean_over(cells, [](const C& c) { return c.taylor_inertia; });
    m.taylor_extent = mean_over(cells, [](const C& c) { return c.taylor_extent; });
    const double mirror = mirror_height(model).si;
    const auto angle = [&](const C& c) {
        return mirrored_inclination(c.inclination_deg, c.y.si, mirror);
    };
    // An axis has no head: +89° and −89° are neighbours, so the doubled angle is averaged.
    const double doubled = std::numbers::pi / 90.0;
    const auto sine = [&](const C& c) { return std::sin(doubled * angle(c)); };
    const auto cosine = [&](const C& c) { return std::cos(doubled * angle(c)); };
    m.inclination_deg = std::atan2(mean_over(cells, sine), mean_over(cells, cosine)) / doubled;
    double squares = 0.0;
    for (const C& c : cells) squares += (c.lambda_C - m.lambda_C) * (c.lambda_C - m.lambda_C);
    const double freedom = static_cast<double>(cells.size()) - 1.0;
    m.lambda_C_sd = freedom > 0.0 ? std::sqrt(squares / freedom) : undefined;
}

/// The worst of all cells.
void measure_extremes(std::span<const CellMeasures> cells, RunMeasures& m) {
    m.area_error_max = m.turn_max_deg = cells.empty() ? undefined : 0.0;
    m.curvature_radius_sites = cells.empty() ? undefined : HUGE_VAL;
    for (const CellMeasures& c : cells) {
        m.area_error_max = std::max(m.area_error_max, std::abs(c.area_error));
        m.turn_max_deg = std::max(m.turn_max_deg, c.turn_max_deg);
        m.curvature_radius_sites = std::min(m.curvature_radius_sites, c.curvature_radius_sites);
    }
}

void measure_layers(const Model& model, const State& state, RunMeasures& m) {
    const auto set = [&](CellFreeLayer layer, Length& bottom, Length& top, Length& mean) {
        bottom = model.scales.to_si<Length>(layer.bottom);
        top = model.scales.to_si<Length>(layer.top);
        mean = model.scales.to_si<Length>(layer.mean());
    };
    const Lattice& lattice = model.lattice;
    std::vector<double> hematocrit;  // left empty, hence no layers, where there are no walls
    const bool straight = !model.boundaries.walls;
    if (lattice.walls && straight) hematocrit = hematocrit_profile(lattice, state.cells);
    const Lattice between{lattice.nx, lattice.ny, lattice.walls && straight};
    set(cfl_gap(between, state.cells), m.cfl_gap_bottom, m.cfl_gap_top, m.cfl_gap);
    set(cfl_envelope(between, state.cells), m.cfl_envelope_bottom, m.cfl_envelope_top,
        m.cfl_envelope);
    set(cfl_profile(hematocrit), m.cfl_profile_bottom, m.cfl_profile_top, m.cfl_profile);
    set(cfl_core(hematocrit), m.cfl_core_bottom, m.cfl_core_top, m.cfl_core);
}

}  // namespace

Length mirror_height(const Model& model) {
    const bool channel = model.lattice.walls && !model.boundaries.walls && !walls_drive(model);
    return model.scales.to_si<Length>(channel ? 0.5 * model.lattice.ny : undefined);
}

double mirrored_inclination(double inclination, double y, double mirror_height) {
    const double rounding = 1e-9 * mirror_height;
    return y > mirror_height + rounding ? -inclination : inclination;
}

double flux(const Model& model, const State& state) {
    return std::visit([&](const auto& sites) { return flux_of(model, sites.velocity); },
                      state.sites);
}

double driving_gradient(const Model& model, const State& state) {
    return state.drive.body_force + model.boundaries.pressure_drop / model.lattice.nx;
}

double wall_shear_stress(const Model& model, const State& state) {
    const WallStress stress =
        std::visit([&](const auto& sites) { return stress_at_walls(model, sites); }, state.sites);
    return 0.5 * (stress.bottom + (walls_drive(model) ? stress.top : -stress.top));
}

double balance_shear_stress(const Model& model, const State& state) {
    const Lattice& lattice = model.lattice;
    if (!walls_drive(model)) return 0.5 * lattice.ny * driving_gradient(model, state);
    const double viscous =
        std::visit([&](const auto& sites) { return viscous_stress(model, sites); }, state.sites);
    double of_forces = 0.0;
    // About the mid-height, so that a net force (of cells on walls, say) weighs on both walls
    // alike.
    const Suspension& cells = state.cells;
    for (int n = 0; n < cells.node_count(); ++n) {
        of_forces += cells.fx[n] * (cells.y[n] - 0.5 * lattice.ny) + cells.dipole_xy[n];
    }
    return (viscous - of_forces) / (static_cast<double>(lattice.nx) * lattice.ny);
}

RunMeasures measure_run(const Model& model, const State& state,
                        std::span<const CellMeasures> cells) {
    RunMeasures m;
    m.time = Time{static_cast<double>(state.step) * model.scales.time};
    m.step = state.step;
    measure_flow(model, state, m);
    const double fastest =
        std::visit([](const auto& sites) { return largest_speed(sites.velocity); }, state.sites);
    measure_hematocrit(model, cells, fastest, m);
    measure_shapes(model, cells, m);
    measure_extremes(cells, m);
    measure_layers(model, state, m);
    m.mach = fastest * std::numbers::sqrt3;
    m.overlaps = static_cast<std::int64_t>(find_overlaps(model.lattice, state.cells).size());
    m.repulsion_count = state.contact.repulsion_count;
    const bool near = state.contact.smallest_gap < model.contact.reach();
    m.smallest_gap = Length{undefined};
    if (near) m.smallest_gap = model.scales.to_si<Length>(state.contact.smallest_gap);
    return m;
}

}  // namespace tt
