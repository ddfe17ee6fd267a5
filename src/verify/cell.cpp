#include "verify/cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/jump.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"
#include "observe/cell_measures.hpp"

namespace tt {
namespace {

using std::numbers::pi;

}  // namespace

TankTreading exact_tank_treading(int viscosity_ratio) {
    if (viscosity_ratio == 1) return {0.438022, 23.4465, 0.164654, 18.93853};
    return {0.314934, 8.8977, 0.079106, 25.79885};
}

Case capsule_case(int viscosity_ratio) {
    Case c;
    c.name = "capsule in shear";
    c.domain = {Length{160e-6}, Length{40e-6}};
    c.flow.drive = ShearDrive{{}, 0.2};
    c.cells.count = 1;
    c.cells.radius = Length{4e-6};
    c.cells.cytoplasm_viscosity.si = viscosity_ratio * c.plasma.viscosity.si;
    c.membrane.bending_modulus.si = 0.0019 * c.membrane.shear_modulus.si * 16e-12;
    c.membrane.hardening.apply_to.clear();
    c.contact.model = NoContact{};
    c.numerics.dx = Length{0.5e-6};
    c.numerics.density_scale = 250.0;
    c.time.end = Time{1.0};
    return c;
}

TankTreading tank_treading(const Case& c, double until_strain) {
    Experiment shear(c);
    shear.advance_to_strain(until_strain);
    const CellMeasures cell = measure_cell(shear.model, shear.state, 0);
    const double rate = shear.model.shear_rate / shear.model.scales.time;
    return {cell.taylor_inertia, cell.inclination_deg, cell.strain,
            2.0 * pi * rate / std::abs(cell.phase_rate.si)};
}

JefferyOrbit jeffery_orbit(const StiffEllipse& scene) {
    const int side = static_cast<int>(std::lround(scene.box));
    constexpr double viscosity = 1.0 / 6.0;
    Model m = plain_model({side, side, true}, viscosity);
    m.kinds[0].jump = jump_correction(m.delta, m.viscosity.plasma, m.viscosity.cytoplasm[0]);
    m.kinds[0].membrane.in_plane = Hookean{0.3 * viscosity};
    m.kinds[0].membrane.bending = CurrentCurvature{2.0 * viscosity};
    m.kinds[0].membrane.area_stiffness = 1.0;
    const double minor = scene.half_length / scene.axis_ratio;
    m.shear_rate = scene.reynolds * viscosity / (scene.half_length * scene.half_length);
    m.boundaries.top_speed = 0.5 * m.shear_rate * side;
    m.boundaries.bottom_speed = -m.boundaries.top_speed;
    Suspension cells;
    std::vector<Vec2> shape = ellipse(scene.half_length, minor, 2000);
    shape = at_equal_arc_length(shape, static_cast<int>(perimeter_of(shape)));
    add_cell(cells, placed(shape, 0.0, {0.5 * side, 0.5 * side}));
    Experiment orbit(m, cells, simple_shear(m.lattice, m.shear_rate));

    JefferyOrbit result;
    result.least_axis_ratio = result.most_axis_ratio = scene.axis_ratio;
    double angle = 0.0, before = 0.0;
    const auto chunk = static_cast<std::int64_t>(0.02 / m.shear_rate);
    double strain = 0.0;
    while (angle > -pi && strain < 100.0) {
        orbit.advance_by(chunk);
        strain += static_cast<double>(chunk) * m.shear_rate;
        const EquivalentEllipse now =
            equivalent_ellipse(area_moments(outline(orbit.state.cells, 0)));
        before = angle;
        double turned = now.inclination - angle;
        turned -= pi * std::round(turned / pi);
        angle += turned;
        const double ratio = now.major / now.minor;
        result.least_axis_ratio = std::min(result.least_axis_ratio, ratio);
        result.most_axis_ratio = std::max(result.most_axis_ratio, ratio);
    }
    // Between the last two looks.
    const double overshoot = (-pi - angle) / (before - angle);
    strain -= overshoot * static_cast<double>(chunk) * m.shear_rate;
    const double r = scene.axis_ratio;
    result.period_ratio = strain / (pi * (r + 1.0 / r));
    return result;
}

double jeffery_period_ratio_of_rigid_ellipse() {
    const auto turned = [](double box, double reynolds) {
        StiffEllipse scene;
        scene.box = box;
        scene.reynolds = reynolds;
        return jeffery_orbit(scene).period_ratio;
    };
    const auto rigid = [&](double box) { return 2.0 * turned(box, 0.2) - turned(box, 0.4); };
    const double narrow = rigid(48.0), wide = rigid(72.0);
    return wide + (wide - narrow) / ((72.0 * 72.0) / (48.0 * 48.0) - 1.0);
}

}  // namespace tt
