#include "observe/run_measures.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "ellipse.hpp"
#include "observe/cell_free_layer.hpp"
#include "observe/cell_measures.hpp"
#include "observe/profiles.hpp"
#include "scene.hpp"

namespace tt {
namespace {

using test::Ellipse;
using test::pi;
using test::Scene;

const Lattice box{80, 60, true};
constexpr double force = 1e-6;
constexpr double viscosity = 1.0 / 6.0;

RunMeasures measured(const Scene& scene) {
    return measure_run(scene.model, scene.state, measure_cells(scene.model, scene.state));
}

Vec2 poiseuille(Vec2 p) { return {force / (2 * viscosity) * p.y * (60 - p.y), 0.0}; }

Scene channel() {
    Scene scene(box);
    scene.state.drive.body_force = force;
    scene.set_velocity(poiseuille);
    return scene;
}

TEST(RunMeasures, plain_poiseuille_flow_has_relative_viscosity_one) {
    for (int ny : {7, 60}) {
        Scene scene(Lattice{16, ny, true});
        scene.state.drive.body_force = 0.25 * force;
        scene.model.boundaries.pressure_drop = 0.75 * force * 16;
        scene.set_velocity([&](Vec2 p) { return Vec2{3 * force * p.y * (ny - p.y), 0.0}; });
        const RunMeasures m = measured(scene);
        EXPECT_NEAR(m.mu_rel, 1.0, 1e-12);
        const Scales& s = scene.model.scales;
        EXPECT_NEAR(m.mu_app.si / s.to_si<Viscosity>(viscosity).si, 1.0, 1e-12);
        EXPECT_NEAR(m.pressure_gradient.si / s.to_si<PressureGradient>(force).si, 1.0, 1e-12);
        const double q = 0.5 * force * ny * ny * ny;
        EXPECT_NEAR(m.flux.si / s.to_si<KinematicViscosity>(q).si, 1.0, 1e-12);
        EXPECT_NEAR(m.wall_shear_stress.si / m.balance_shear_stress.si, 1.0, 1e-12);
        EXPECT_NEAR(m.mach, std::sqrt(3.0) * scene.state.velocity(0, ny / 2).x, 1e-15);
        EXPECT_EQ(m.hematocrit_tube, 0.0);
        EXPECT_TRUE(std::isnan(m.lambda_C));
        EXPECT_TRUE(std::isnan(m.cfl_gap.si));
    }
}

TEST(RunMeasures, the_unit_of_the_paper_and_si_agree_on_eq_22) {
    const RunMeasures m = measured(channel());
    const double h = 2e-7, height = 60 * h;
    const double by_eq_22 = m.pressure_gradient.si * std::pow(height, 3) / (12 * m.flux.si);
    EXPECT_NEAR(m.mu_app.si / by_eq_22, 1.0, 1e-12);
    EXPECT_NEAR(m.pseudo_shear_rate.si * height / m.mean_velocity.si, 1.0, 1e-12);
}

TEST(RunMeasures, plain_couette_flow_has_relative_viscosity_one) {
    const double k = 1e-4;
    Scene scene(box);
    scene.model.boundaries = {-30 * k, 30 * k, 0.0};
    scene.set_velocity([&](Vec2 p) { return Vec2{k * (p.y - 30), 0.0}; });
    const RunMeasures m = measured(scene);
    EXPECT_NEAR(m.mu_rel, 1.0, 1e-12);
    EXPECT_NEAR(m.balance_shear_stress.si / m.wall_shear_stress.si, 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(m.hematocrit_discharge));
}

TEST(RunMeasures, wall_stress_equals_the_mean_stress_less_the_moment_of_the_forces) {
    // Couette flow held back in the middle by a force f per length on the line y = 20 and −f on
    // y = 40: the slope jumps there, ν (outer − inner) = f.
    const double k = 1e-4, f = 1e-5;
    const double inner = k - f / viscosity * 40.0 / 60.0, outer = inner + f / viscosity;
    const auto u = [&](double y) {
        const double middle = std::clamp(y, 20.0, 40.0) - 30.0;
        return inner * middle + outer * (y - 30.0 - middle);
    };
    Scene scene(box);
    scene.model.boundaries = {-30 * k, 30 * k, 0.0};
    ASSERT_NEAR(u(60.0), 30 * k, 1e-15);
    scene.set_velocity([&](Vec2 p) { return Vec2{u(p.y), 0.0}; });
    scene.add(Ellipse{{40, 30}, 10, 10, 0.0}.nodes(40));
    // Node forces with the same sums: nodes at y = 20 and 40 are at θ = 3π/2 and π/2.
    scene.state.cells.fx[10] = -f * 80;
    scene.state.cells.fx[30] = f * 80;
    const RunMeasures m = measured(scene);
    const Pressure exact = scene.model.scales.to_si<Pressure>(viscosity * outer);
    EXPECT_NEAR(m.wall_shear_stress.si / exact.si, 1.0, 1e-12);
    EXPECT_NEAR(m.balance_shear_stress.si / m.wall_shear_stress.si, 1.0, 1e-12);
    EXPECT_NEAR(m.mu_rel, outer / k, 1e-12);
}

TEST(RunMeasures, hematocrit_in_plug_flow_is_the_same_in_tube_and_discharge) {
    Scene scene(box);
    scene.model.lattice.walls = true;
    scene.set_velocity([](Vec2) { return Vec2{0.01, 0.0}; });
    scene.model.boundaries = {0.01, 0.01, 0.0};  // walls move along: no shear anywhere
    scene.model.shear_rate = 1e-3;               // something drives the flow
    scene.add(Ellipse{{20, 20}, 10, 8, 0.3}.nodes(64));
    scene.add(Ellipse{{60, 38}, 12, 6, -0.2}.nodes(64));
    scene.set_node_velocity([](Vec2) { return Vec2{0.01, 0.0}; });
    const RunMeasures m = measured(scene);
    const std::vector<double>& areas = scene.state.cells.reference_area;
    EXPECT_NEAR(m.hematocrit_tube, (areas[0] + areas[1]) / 4800, 1e-14);
    EXPECT_NEAR(m.hematocrit_discharge, m.hematocrit_tube, 1e-13);
}

TEST(RunMeasures, a_cell_in_mid_channel_runs_ahead_so_discharge_exceeds_tube_hematocrit) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30}, 10, 10, 0.0}.nodes(64));
    scene.set_node_velocity([](Vec2) { return poiseuille({0, 30}); });
    scene.model.shear_rate = 1e-3;
    const RunMeasures m = measured(scene);
    EXPECT_NEAR(m.hematocrit_discharge / m.hematocrit_tube, 1.5, 1e-12);
    // Where nothing drives the flow, what moves is the cells' own doing.
    scene.model.shear_rate = 0.0;
    EXPECT_TRUE(std::isnan(measured(scene).hematocrit_discharge));
}

/// Two discs in a channel of 60: bottom of the lower one at 12, top of the higher one at 52.
Scene two_discs() {
    Scene scene = channel();
    scene.add(Ellipse{{20, 22}, 10, 10, 0.0}.nodes(400));
    scene.add(Ellipse{{60, 40}, 12, 12, 0.0}.nodes(400));
    scene.set_node_velocity(poiseuille);
    return scene;
}

TEST(CellFreeLayer, gap_is_the_smallest_distance_to_each_wall) {
    const Scene scene = two_discs();
    const CellFreeLayer layer = cfl_gap(box, scene.state.cells);
    EXPECT_NEAR(layer.bottom, 12.0, 1e-12);
    EXPECT_NEAR(layer.top, 8.0, 1e-12);
}

TEST(CellFreeLayer, envelope_is_the_mean_over_columns_that_hold_a_cell) {
    const Scene scene = two_discs();
    const CellFreeLayer layer = cfl_envelope(box, scene.state.cells);
    // Discs do not share a column; the mean height of a half disc of radius a is π a/4.
    const double bottom = (20 * (22 - pi / 4 * 10) + 24 * (40 - pi / 4 * 12)) / 44;
    const double top = (20 * (38 - pi / 4 * 10) + 24 * (20 - pi / 4 * 12)) / 44;
    EXPECT_NEAR(layer.bottom, bottom, 0.05);
    EXPECT_NEAR(layer.top, top, 0.05);
    fmt::print("envelope off by {:.3f} and {:.3f} sites\n", layer.bottom - bottom, layer.top - top);
}

TEST(CellFreeLayer, envelope_takes_the_outermost_of_several_cells_in_a_column) {
    Scene scene = channel();
    scene.add({{30, 10}, {40, 10}, {50, 10}, {50, 15}, {50, 20}, {40, 20}, {30, 20}, {30, 15}});
    scene.add({{30, 35}, {40, 35}, {50, 35}, {50, 40}, {50, 45}, {40, 45}, {30, 45}, {30, 40}});
    const CellFreeLayer layer = cfl_envelope(box, scene.state.cells);
    EXPECT_NEAR(layer.bottom, 10.0, 1e-12);
    EXPECT_NEAR(layer.top, 15.0, 1e-12);
}

TEST(CellFreeLayer, profile_is_where_hematocrit_reaches_half_its_maximum) {
    // Rows at ½, 3/2, …: rises from 0 to 0.4 between 2½ and 4½, falls from 0.4 to 0 between 7½ and
    // 8½.
    const std::vector<double> h{0, 0, 0, 0.2, 0.4, 0.4, 0.4, 0.4, 0, 0};
    EXPECT_NEAR(cfl_profile(h).bottom, 3.5, 1e-12);
    EXPECT_NEAR(cfl_profile(h).top, 2.0, 1e-12);
    const std::vector<double> full(10, 0.4);  // to the walls, where H = 0 by definition
    EXPECT_NEAR(cfl_profile(full).bottom, 0.25, 1e-12);
}

TEST(CellFreeLayer, core_holds_all_cells_at_the_peak_hematocrit) {
    const std::vector<double> h{0, 0, 0, 0.2, 0.4, 0.4, 0.4, 0.4, 0, 0};
    EXPECT_NEAR(cfl_core(h).bottom, 5 - 0.6 / 0.4, 1e-12);
    EXPECT_NEAR(cfl_core(h).top, 5 - 1.2 / 0.4, 1e-12);
    const std::vector<double> odd{0, 0.4, 0.4, 0.4, 0};
    EXPECT_NEAR(cfl_core(odd).bottom, 1.0, 1e-12);
    EXPECT_NEAR(cfl_core(odd).top, 1.0, 1e-12);
}

TEST(CellFreeLayer, all_definitions_agree_on_a_full_core_and_differ_on_discs) {
    Scene core = channel();
    std::vector<Vec2> slab;  // one cell as long as the box, 15 ≤ y ≤ 45
    for (int i = 0; i < 80; ++i) slab.push_back({1.0 * i, 15.0});
    for (int j = 15; j < 45; ++j) slab.push_back({80.0, 1.0 * j});
    for (int i = 80; i > 0; --i) slab.push_back({1.0 * i, 45.0});
    for (int j = 45; j > 15; --j) slab.push_back({0.0, 1.0 * j});
    core.add(slab);
    const auto h = hematocrit_profile(box, core.state.cells);
    const Suspension& cells = core.state.cells;
    for (const CellFreeLayer& layer :
         {cfl_gap(box, cells), cfl_envelope(box, cells), cfl_profile(h), cfl_core(h)}) {
        EXPECT_NEAR(layer.bottom, 15.0, 1e-12);
        EXPECT_NEAR(layer.top, 15.0, 1e-12);
    }
    const RunMeasures discs = measured(two_discs());
    const double percent = 0.01 * 60 * 2e-7;
    fmt::print("two discs: gap {:.1f} envelope {:.1f} profile {:.1f} core {:.1f} % of the width\n",
               discs.cfl_gap.si / percent, discs.cfl_envelope.si / percent,
               discs.cfl_profile.si / percent, discs.cfl_core.si / percent);
    EXPECT_GT(discs.cfl_envelope.si, 1.5 * discs.cfl_gap.si);
}

TEST(Profiles, hematocrit_profile_of_a_disc_is_its_chord_and_sums_to_the_tube_hematocrit) {
    Scene scene = channel();
    scene.add(Ellipse{{79, 30}, 10, 10, 0.0}.nodes(1000));
    const Profiles p = measure_profiles(scene.model, scene.state);
    EXPECT_NEAR(p.hematocrit[29], 2 * std::sqrt(100 - 0.25) / 80, 1e-5);
    EXPECT_NEAR(p.hematocrit[36], 2 * std::sqrt(100 - 6.5 * 6.5) / 80, 1e-5);
    EXPECT_EQ(p.hematocrit[19], 0.0);
    EXPECT_EQ(p.hematocrit[40], 0.0);
    const double mean = std::accumulate(p.hematocrit.begin(), p.hematocrit.end(), 0.0) / 60;
    const double tube = measured(scene).hematocrit_tube;
    fmt::print("mean of the profile / tube hematocrit − 1 = {:.1e}\n", mean / tube - 1);
    EXPECT_NEAR(mean / tube, 1.0, 0.01);
    const double u = scene.model.scales.to_si<Velocity>(poiseuille({0, 7.5}).x).si;
    EXPECT_NEAR(p.velocity[7], u, 1e-12 * u);
}

TEST(RunMeasures, overlaps_count_the_nodes_inside_another_cell) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30}, 10, 10, 0.0}.nodes(64));
    scene.add(Ellipse{{39.5, 30}, 10, 10, 0.0}.nodes(64));
    // The circles cross at cos θ = 9.75/10, θ = 0.224: nodes 0, ±1, ±2 of each, 2π/64 apart.
    EXPECT_EQ(measured(scene).overlaps, 10);
    for (int n = 64; n < 128; ++n) scene.state.cells.x[n] += 1.0;
    EXPECT_EQ(measured(scene).overlaps, 0);
}

TEST(RunMeasures, inclination_is_averaged_as_an_axis_not_as_a_number) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30}, 10, 6, 85 * pi / 180}.nodes(64));
    scene.add(Ellipse{{60, 30}, 10, 6, -85 * pi / 180}.nodes(64));
    EXPECT_NEAR(std::abs(measured(scene).inclination_deg), 90.0, 1e-9);
}

TEST(RunMeasures, cells_of_both_halves_of_a_channel_lean_the_same_way_with_the_shear) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 18}, 10, 6, 20 * pi / 180}.nodes(64));
    scene.add(Ellipse{{60, 42}, 10, 6, -20 * pi / 180}.nodes(64));
    EXPECT_NEAR(measured(scene).inclination_deg, 20.0, 1e-9);
    scene.model.boundaries = {-0.01, 0.01, 0.0};  // walls that drive: one shear from wall to wall
    EXPECT_NEAR(std::abs(measured(scene).inclination_deg), 0.0, 1e-9);
}

TEST(RunMeasures, what_is_not_defined_is_no_number) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30}, 10, 10, 0.0}.nodes(64));
    scene.model.contact.law = Morse{};
    scene.model.contact.range = 5.0;
    scene.state.contact.smallest_gap = 5.0;  // none is nearer
    const RunMeasures m = measured(scene);
    EXPECT_TRUE(std::isnan(m.inclination_deg)) << "of a circle";
    EXPECT_TRUE(std::isnan(m.lambda_C_sd)) << "of one cell";
    EXPECT_TRUE(std::isnan(m.smallest_gap.si));
    scene.state.contact.smallest_gap = 4.0;
    EXPECT_NEAR(m.area_error_max, 0.0, 1e-12);
    EXPECT_NEAR(measured(scene).smallest_gap.si, 8e-7, 1e-18);
}

TEST(RunMeasures, largest_turn_and_smallest_radius_are_those_of_the_tips) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30}, 10, 5, 0.4}.nodes(400));
    scene.add(Ellipse{{60, 30}, 10, 10, 0.0}.nodes(36));
    const RunMeasures m = measured(scene);
    EXPECT_NEAR(m.curvature_radius_sites, 5.0 * 5.0 / 10.0, 0.01);  // b²/a
    EXPECT_NEAR(m.turn_max_deg, 10.0, 1e-9);  // of the coarser circle: 360°/36
}

template <class F>
void for_each_number(const RunMeasures& m, F f) {
    for_each_field<RunMeasures>([&](const auto& entry) {
        const auto value = m.*entry.member;
        if constexpr (requires { value.si; }) {
            f(entry.key, value.si);
        } else {
            f(entry.key, static_cast<double>(value));
        }
    });
}

void expect_same(const RunMeasures& a, const RunMeasures& b) {
    std::vector<double> numbers;
    for_each_number(a, [&](auto, double v) { numbers.push_back(v); });
    std::size_t n = 0;
    for_each_number(b, [&](auto key, double v) {
        const double expected = numbers[n++];
        EXPECT_EQ(std::isnan(v), std::isnan(expected)) << key;
        if (std::isnan(v)) return;
        EXPECT_NEAR(v, expected, 1e-9 * std::abs(expected)) << key;
    });
}

/// Two ellipses of which one is stretched by a tenth; `up` = −1: upside down.
Scene two_ellipses(double up) {
    Scene scene = channel();
    scene.add(Ellipse{{20, 30 - 8 * up}, 14, 9, 0.3 * up}.nodes(64, 0.1 * up));
    scene.add(Ellipse{{60, 30 + 11 * up}, 12, 8, 0.7 * up}.nodes(64, 0.1 * up));
    for (int n = 64; n < 128; ++n) scene.state.cells.x[n] += 0.1 * (scene.state.cells.x[n] - 60);
    scene.set_node_velocity(poiseuille);
    return scene;
}

TEST(RunMeasures, shifting_along_the_channel_by_sites_or_boxes_changes_nothing) {
    const RunMeasures here = measured(two_ellipses(1));
    for (double shift : {-80.0, 27.0, 8000.0}) {
        Scene moved = two_ellipses(1);
        for (double& x : moved.state.cells.x) x += shift;
        expect_same(here, measured(moved));
    }
}

TEST(RunMeasures, mirroring_the_channel_swaps_bottom_and_top) {
    RunMeasures m = measured(two_ellipses(-1));
    std::swap(m.cfl_gap_bottom, m.cfl_gap_top);
    std::swap(m.cfl_envelope_bottom, m.cfl_envelope_top);
    std::swap(m.cfl_profile_bottom, m.cfl_profile_top);
    std::swap(m.cfl_core_bottom, m.cfl_core_top);
    expect_same(measured(two_ellipses(1)), m);
}

}  // namespace
}  // namespace tt
