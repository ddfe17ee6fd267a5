#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "membrane/outline.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "verify/experiment.hpp"

// Short versions of what the studies tumbling, migration and fahraeus follow for longer.

namespace tt {
namespace {

/// A biconcave cell in shear between walls 16 um apart, h = 0.25 um.
Case biconcave_in_shear(double viscosity_ratio) {
    Case c;
    c.domain = {Length{32e-6}, Length{16e-6}};
    c.flow.drive = ShearDrive{{}, 0.1};
    c.cells.count = 1;
    c.cells.shape = BiconcaveShape{};
    c.cells.radius = Length{3.91e-6};
    c.cells.cytoplasm_viscosity.si = viscosity_ratio * c.plasma.viscosity.si;
    c.membrane.hardening.apply_to.clear();
    c.contact.model = NoContact{};
    c.numerics.dx = Length{0.25e-6};
    c.time.end = Time{1.0};
    return c;
}

/// By how much the long axis has turned [deg] until k t.
double axis_turned(const Case& c, double until_strain) {
    Experiment shear(c);
    double turned = 0.0, before = 0.0;
    for (double strain = 0.2; strain <= until_strain; strain += 0.2) {
        shear.advance_to_strain(strain);
        const double now =
            equivalent_ellipse(area_moments(outline(shear.state.cells, 0))).inclination;
        turned += std::remainder(now - before, M_PI);
        before = now;
    }
    return turned * 180.0 / M_PI;
}

TEST(BiconcaveCell, tank_treads_when_its_inside_is_thin_and_tumbles_when_it_is_thick) {
    const double thin = axis_turned(biconcave_in_shear(1.0), 12.0);
    const double thick = axis_turned(biconcave_in_shear(20.0), 12.0);
    std::printf("G = 0.1, k t = 12: axis turned by %.1f deg at ratio 1, %.1f deg at ratio 20\n",
                thin, thick);
    EXPECT_GT(thin, 5.0);
    EXPECT_LT(thin, 30.0);
    EXPECT_LT(thick, -150.0);
}

PressureDrive driven_at(double pseudo_shear_rate) {
    PressureDrive drive;
    drive.pseudo_shear_rate = Rate{pseudo_shear_rate};
    return drive;
}

/// One circular cell at this height of a channel 20 um wide, h = 0.5 um.
Case cell_in_channel(double height, double shear_modulus) {
    Case c;
    c.domain = {Length{40e-6}, Length{20e-6}};
    c.flow.drive = driven_at(200.0);
    c.cells.layout = AtPositions{{{Length{20e-6}, Length{height}}}};
    c.cells.radius = Length{3e-6};
    c.cells.cytoplasm_viscosity = c.plasma.viscosity;
    c.membrane.shear_modulus = Tension{shear_modulus};
    c.membrane.hardening.apply_to.clear();
    c.contact.model = NoContact{};
    c.numerics.dx = Length{0.5e-6};
    c.numerics.density_scale = 10.0;
    c.time.end = Time{1.0};
    return c;
}

/// Where its centroid is after 10 ms [um from the bottom wall].
double height_after(const Case& c, double milliseconds) {
    Experiment channel(c);
    channel.advance_by(std::lround(1e-3 * milliseconds / channel.model.scales.time));
    return measure_cell(channel.model, channel.state, 0).y.si * 1e6;
}

TEST(CellInChannel, migrates_towards_the_centre_line_the_faster_the_softer_it_is) {
    const double soft = height_after(cell_in_channel(6e-6, 6e-6), 10.0) - 6.0;
    const double from_above = height_after(cell_in_channel(14e-6, 6e-6), 10.0) - 14.0;
    const double stiff = height_after(cell_in_channel(6e-6, 60e-6), 10.0) - 6.0;
    std::printf("moved in 10 ms: %+.3f um, from above %+.3f um, ten times stiffer %+.3f um\n", soft,
                from_above, stiff);
    EXPECT_GT(soft, 0.5);
    EXPECT_NEAR(from_above, -soft, 1e-6);
    EXPECT_LT(stiff, 0.85 * soft);  // not by much: D ~ G^(1/3)
}

TEST(CellInChannel, does_not_feel_its_own_speed_only_if_advection_is_kept_or_the_density_is_low) {
    // Without advection a density raised S times makes S ρ ∂u/∂t of every flow that is carried
    // along: inertia at the Reynolds number of the speed, not of the shear rate
    // (docs/theory/fluid.md).
    const auto height = [](const Equilibrium& equilibrium, double density_scale) {
        Case c = cell_in_channel(6e-6, 6e-6);
        c.numerics.equilibrium = equilibrium;
        c.numerics.density_scale = density_scale;
        return height_after(c, 10.0);
    };
    const double stokes = height(LinearEquilibrium{}, 5.0);
    const double linear = height(LinearEquilibrium{}, 80.0),
                 advected = height(IncompressibleEquilibrium{}, 80.0);
    std::printf("height after 10 ms: %.3f um at S = 5; at S = 80 %.3f um, with advection %.3f um\n",
                stokes, linear, advected);
    EXPECT_GT(std::abs(linear - stokes), 0.2);
    EXPECT_LT(std::abs(advected - stokes), 0.25 * std::abs(linear - stokes));
}

TEST(CellsInChannel, flow_out_at_a_higher_hematocrit_than_they_have_in_the_channel) {
    Case c;
    c.domain = {Length{80e-6}, Length{20e-6}};
    c.flow.drive = driven_at(500.0);
    c.cells.count = 12;
    c.cells.layout = PaperRows{};
    c.numerics.dx = Length{0.4e-6};
    c.time.end = Time{1.0};
    Experiment channel(c);
    const auto after = [&](double ms) {
        channel.advance_by(std::lround(1e-3 * ms / channel.model.scales.time) - channel.state.step);
        const RunMeasures m =
            measure_run(channel.model, channel.state, measure_cells(channel.model, channel.state));
        std::printf("%2.0f ms: tube %.3f, discharge %.3f, mu_rel %.3f, layer %.2f um\n", ms,
                    m.hematocrit_tube, m.hematocrit_discharge, m.mu_rel, m.cfl_envelope.si * 1e6);
        return m;
    };
    const RunMeasures early = after(1.0), late = after(10.0);
    EXPECT_GT(early.hematocrit_discharge, 1.05 * early.hematocrit_tube);
    EXPECT_GT(late.hematocrit_discharge, early.hematocrit_discharge);
    EXPECT_GT(late.cfl_envelope, early.cfl_envelope);
    EXPECT_GT(late.mu_rel, 1.1);
}

}  // namespace
}  // namespace tt
