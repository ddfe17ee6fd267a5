#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "observe/cell_measures.hpp"
#include "verify/cell.hpp"

// Bodies that keep their shape, at the time steps that soft cells take.

namespace tt {
namespace {

/// One body in a box without contact forces.
Case one_rigid_body(double along, double across, double radius, double dx) {
    Case c;
    c.name = "rigid body";
    c.domain = {Length{along}, Length{across}};
    c.cells.count = 1;
    c.cells.radius = Length{radius};
    c.membrane.rigid = true;
    c.contact.model = NoContact{};
    c.numerics.dx = Length{dx};
    c.time.end = Time{1.0};
    return c;
}

/// Faxén: U = u + a²/4 Δu, in the middle of a parabola of half width Y u_max (1 − a²/(2 Y²)).
TEST(RigidBodies, disc_in_the_middle_of_a_channel_lags_as_faxen_says) {
    Case c = one_rigid_body(80e-6, 40e-6, 4e-6, 0.4e-6);
    PressureDrive drive;
    drive.pseudo_shear_rate = Rate{100.0};
    c.flow.drive = drive;
    Experiment channel(c);
    channel.advance_by(10000);
    const CellMeasures body = measure_cell(channel.model, channel.state, 0);
    const double ratio = body.velocity.si / (1.5 * 100.0 * 40e-6);
    std::printf("U/u_max %.4f (0.9800)\n", ratio);
    EXPECT_NEAR(ratio, 0.980, 0.001);
    EXPECT_NEAR(body.lambda_C, 1.0, 1e-9);
}

/// A half turn takes k t = π (r + 1/r), in unbounded shear.
TEST(RigidBodies, ellipse_turns_as_jeffery_says) {
    Case c = one_rigid_body(160e-6, 160e-6, 4e-6, 0.8e-6);
    c.flow.drive = ShearDrive{Rate{100.0}, {}};
    c.cells.shape = EllipseShape{2.0};
    Experiment shear(c);
    const double half_turn = std::numbers::pi * 2.5;  // in k t
    double angle = 0.0, begin = 0.0, end = 0.0;       // turned, and k t at 90 and 270 degrees
    const double step = 100.0 * shear.model.scales.time;
    while (angle > -1.5 * std::numbers::pi && shear.time() * step < 2.5 * half_turn) {
        constexpr int steps = 20;
        const double before = angle, now = shear.time() * step;
        const Suspension& cells = shear.state.cells;
        const int opposite = cells.node_count() / 2;
        const Vec2 from = cells.position(opposite) - cells.position(0);
        shear.advance_by(steps);
        const Vec2 to = cells.position(opposite) - cells.position(0);
        angle += std::atan2(cross(from, to), dot(from, to));
        const auto at = [&](double wanted) {
            return now + steps * step * (wanted - before) / (angle - before);
        };
        const double quarter = -0.5 * std::numbers::pi, more = -1.5 * std::numbers::pi;
        if (before > quarter && angle <= quarter) begin = at(quarter);
        if (before > more && angle <= more) end = at(more);
    }
    std::printf("half a turn in k t %.3f (%.3f)\n", end - begin, half_turn);
    EXPECT_NEAR((end - begin) / half_turn, 1.0, 0.01);
}

/// Segré and Silberberg: at channel Reynolds number 13.9 a disc of a quarter of the width comes to
/// a height of 0.2723 widths (Pan and Glowinski, J. Comput. Phys. 181, 2002; Inamuro, Maeba and
/// Ogino, Int. J. Multiphase Flow 26, 2000, found 0.2745).
TEST(RigidBodies, disc_settles_between_middle_and_wall_as_segre_and_silberberg_saw) {
    Case c = one_rigid_body(40e-6, 40e-6, 5e-6, 0.5e-6);
    BodyForceDrive drive;
    drive.pseudo_shear_rate = Rate{13.911 * 1e-6 / (40e-6 * 40e-6)};
    c.flow.drive = drive;
    c.plasma = {Viscosity{1e-3}, Density{1000.0}};
    c.cells.layout = AtPositions{{{Length{20e-6}, Length{11.3e-6}}}};
    c.numerics.density_scale = 1.0;
    c.numerics.dt = Time{20e-9};
    Experiment channel(c);
    channel.advance_by(125'000);
    const CellMeasures body = measure_cell(channel.model, channel.state, 0);
    std::printf("height %.4f (0.2723)\n", body.y.si / 40e-6);
    EXPECT_NEAR(body.y.si / 40e-6 / 0.2723, 1.0, 0.005);
}

}  // namespace
}  // namespace tt
