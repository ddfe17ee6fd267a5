#include "verify/drop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "coupling/jump.hpp"
#include "fluid/moments.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"
#include "observe/run_measures.hpp"

namespace tt {
namespace {

using std::numbers::pi;

Model drop_model(const DropScene& scene, double tension) {
    const int side = static_cast<int>(std::lround(scene.box));
    Model m = plain_model({side, side, true}, scene.viscosity);
    m.viscosity.cytoplasm = {scene.viscosity * scene.viscosity_ratio};
    m.kinds[0].jump = jump_correction(m.delta, m.viscosity.plasma, m.viscosity.cytoplasm[0]);
    m.kinds[0].membrane.in_plane = SurfaceTension{tension};
    m.kinds[0].membrane.area_stiffness = 1.0;
    return m;
}

/// Raises the pressure inside by γ/a before the first step, so that the drop need not first shrink
/// to compress its fluid.
void pressurise(Experiment& drop, double pressure) {
    const Lattice& lattice = drop.model.lattice;
    const auto raise = [&](int k, int i, int j) {
        const double gain = 3.0 * pressure * d2q9::weight[k] * drop.state.interior.cytoplasm(i, j);
        std::visit(
            [&](auto& sites) {
                sites.populations.set_slot(k, i, j, sites.populations.slot(k, i, j) + gain);
            },
            drop.state.sites);
    };
    for (int k = 0; k < d2q9::count; ++k) {
        for (int j = 0; j < lattice.ny; ++j) {
            for (int i = 0; i < lattice.nx; ++i) raise(k, i, j);
        }
    }
}

int node_count(const DropScene& scene) {
    return static_cast<int>(std::lround(2.0 * pi * scene.radius / scene.node_distance));
}

/// Amplitude of cos nθ in r(θ) about the centroid, over the mean radius.
double mode_amplitude(const Outline& outline, int mode) {
    const Vec2 centre = area_moments(outline).centroid;
    const int count = outline.size();
    double sum = 0.0, mean = 0.0;
    for (int k = 0; k < count; ++k) {
        const Vec2 here = outline[k] - centre, next = outline[(k + 1) % count] - centre;
        const double angle = std::atan2(here.y, here.x);
        const double step = std::atan2(cross(here, next), dot(here, next));
        const double next_angle = angle + step;
        sum += 0.5 * step *
               (norm(here) * std::cos(mode * angle) + norm(next) * std::cos(mode * next_angle));
        mean += 0.5 * step * (norm(here) + norm(next));
    }
    return sum / pi / (mean / (2.0 * pi));
}

}  // namespace

LaplacePressure laplace_pressure(double radius, double tension) {
    DropScene scene;
    scene.radius = radius;
    scene.box = std::round(5.0 * radius);
    Model m = drop_model(scene, tension);
    m.lattice.walls = false;
    m.kinds[0].membrane.area_stiffness = 0.0;  // it would carry part of the pressure itself
    Suspension cells;
    const Vec2 middle{0.5 * m.lattice.nx + 0.2, 0.5 * m.lattice.ny + 0.3};  // on no symmetric place
    add_cell(cells, placed(circle(radius, node_count(scene)), 0.0, middle));
    Experiment rest(m, cells);
    rest.advance_by(static_cast<std::int64_t>(6.0 * radius * radius / scene.viscosity));

    const auto pressure = [&](int i, int j) {
        return rest.state.moments(i, j).density_deviation / 3.0;
    };
    const double drop = pressure(m.lattice.nx / 2, m.lattice.ny / 2) - pressure(0, 0);
    const double present = std::sqrt(signed_area(outline(rest.state.cells, 0)) / pi);
    LaplacePressure result;
    result.ratio = drop * present / tension;
    for (int j = 0; j < m.lattice.ny; ++j) {
        for (int i = 0; i < m.lattice.nx; ++i)
            result.spurious_flow = std::max(
                result.spurious_flow, norm(rest.state.velocity(i, j)) * scene.viscosity / tension);
    }
    return result;
}

double relaxation_time_ratio(const DropScene& scene, int mode) {
    // Slow against the diffusion of momentum over the drop, a²/ν: Stokes flow.
    constexpr double slowness = 20.0;
    const double sum = scene.viscosity * (1.0 + scene.viscosity_ratio);
    const double decay_time = slowness * scene.radius * scene.radius / scene.viscosity;
    const double tension = 2.0 * scene.radius * sum / (mode * decay_time);
    Model m = drop_model(scene, tension);
    Suspension cells;
    std::vector<Vec2> points = circle(scene.radius, node_count(scene));
    for (Vec2& p : points) p *= 1.0 + 0.02 * std::cos(mode * std::atan2(p.y, p.x));
    add_cell(cells, placed(points, 0.0, {0.5 * m.lattice.nx, 0.5 * m.lattice.ny}));
    Experiment drop(m, cells);
    pressurise(drop, tension / scene.radius);
    const auto third = static_cast<std::int64_t>(decay_time / 3.0);
    drop.advance_by(third);
    const double before = mode_amplitude(outline(drop.state.cells, 0), mode);
    drop.advance_by(third);
    const double after = mode_amplitude(outline(drop.state.cells, 0), mode);
    const double rate = std::log(before / after) / static_cast<double>(third);
    return 1.0 / (rate * decay_time);
}

DropInShear drop_in_shear(const DropScene& scene, double capillary_number, double until_strain) {
    constexpr double reynolds = 0.15;  // of the approach only: the steady state is a Stokes flow
    const double rate = reynolds * scene.viscosity / (scene.radius * scene.radius);
    const double tension = scene.viscosity * rate * scene.radius / capillary_number;
    Model m = drop_model(scene, tension);
    m.shear_rate = rate;
    m.boundaries.top_speed = 0.5 * rate * m.lattice.ny;
    m.boundaries.bottom_speed = -m.boundaries.top_speed;
    Suspension cells;
    add_cell(cells, placed(circle(scene.radius, node_count(scene)), 0.0,
                           {0.5 * m.lattice.nx, 0.5 * m.lattice.ny}));
    const double area = cells.reference_area[0];
    Experiment drop(m, cells, simple_shear(m.lattice, rate));
    pressurise(drop, tension / scene.radius);
    drop.advance_to_strain(until_strain);

    const Outline shape = outline(drop.state.cells, 0);
    const AreaMoments parts = area_moments(shape);
    const EquivalentEllipse ellipse = equivalent_ellipse(parts);
    DropInShear result;
    result.taylor = taylor_deformation(ellipse.major, ellipse.minor);
    result.inclination = ellipse.inclination;
    result.area_error = parts.area / area - 1.0;
    const double fraction = parts.area / (double(m.lattice.nx) * m.lattice.ny);
    const double plain = scene.viscosity * rate;
    result.intrinsic_viscosity = (balance_shear_stress(m, drop.state) / plain - 1.0) / fraction;
    double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < shape.size(); ++k) {
        const double length = norm(shape[(k + 1) % shape.size()] - shape[k]);
        longest = std::max(longest, length);
        shortest = std::min(shortest, length);
    }
    result.spacing_ratio = longest / shortest;
    return result;
}

DropInShear drop_in_unbounded_shear(double viscosity_ratio, double capillary_number,
                                    double until_strain) {
    const auto in_box = [&](double radius, double radii) {
        DropScene scene;
        scene.radius = radius;
        scene.box = radii * radius;
        scene.viscosity_ratio = viscosity_ratio;
        scene.viscosity = 1.0;
        return drop_in_shear(scene, capillary_number, until_strain);
    };
    const DropInShear coarse = in_box(7.0, 8.0), fine = in_box(14.0, 8.0), wide = in_box(7.0, 16.0);
    const auto limit = [&](double DropInShear::*number) {
        return (4.0 * fine.*number - coarse.*number) / 3.0 +
               4.0 / 3.0 * (wide.*number - coarse.*number);
    };
    DropInShear result = fine;
    result.taylor = limit(&DropInShear::taylor);
    result.inclination = limit(&DropInShear::inclination);
    result.intrinsic_viscosity = limit(&DropInShear::intrinsic_viscosity);
    return result;
}

double drop_deformation(double viscosity_ratio, double capillary_number) {
    return 1.0 / std::hypot(1.0 / capillary_number, 1.0 + viscosity_ratio);
}

double drop_intrinsic_viscosity(double viscosity_ratio) {
    return (1.0 + 2.0 * viscosity_ratio) / (1.0 + viscosity_ratio);
}

}  // namespace tt
