#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "base/parallel.hpp"
#include "coupling/viscosity.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"
#include "random_cells.hpp"

namespace {

using namespace tt;

Outline as_outline(const std::vector<Vec2>& points, std::vector<double>& x,
                   std::vector<double>& y) {
    x.clear();
    y.clear();
    for (const Vec2 p : points) {
        x.push_back(p.x);
        y.push_back(p.y);
    }
    return {x, y};
}

template <class Fill>
Patch filled(const Fill& fill, const std::vector<Vec2>& points) {
    std::vector<double> x, y;
    Patch patch;
    LocalOutline local;
    EXPECT_TRUE(lay_patch(as_outline(points, x, y), 0.0, 1e4, patch, local));
    fill(local, patch);
    return patch;
}

double sum(const Patch& patch) {
    double total = 0.0;
    for (const double v : patch.value) total += v;
    return total;
}

void expect_same_interior(const std::vector<Vec2>& points, const char* what) {
    const Patch scan = filled(ScanLine{}, points);
    const Patch flood = filled(FloodFill{}, points);
    ASSERT_TRUE(scan.same_place(flood));
    int differ = 0;
    for (std::size_t k = 0; k < scan.value.size(); ++k) {
        ASSERT_TRUE(scan.value[k] == 0.0 || scan.value[k] == 1.0) << what;
        differ += scan.value[k] != flood.value[k];
    }
    EXPECT_EQ(differ, 0) << what;
}

TEST(Interior, scan_line_equals_flood_fill_for_random_smooth_shapes) {
    Random random(1);
    for (int trial = 0; trial < 400; ++trial) {
        const int nodes = 12 + static_cast<int>(random.uniform(0.0, 130.0));
        auto points = random_cells::smooth_shape(random, random.uniform(1.5, 25.0), nodes);
        points = placed(points, 0.0, {random.uniform(-900.0, 900.0), random.uniform(0.0, 100.0)});
        expect_same_interior(points, "smooth");
    }
}

TEST(Interior, scan_line_equals_flood_fill_for_shapes_thinner_than_a_site) {
    Random random(2);
    for (int trial = 0; trial < 300; ++trial) {
        const double thickness = std::pow(10.0, random.uniform(-4.0, 0.3));
        auto points = ellipse(random.uniform(4.0, 30.0), thickness, 80);
        points = placed(points, random.uniform(0.0, 7.0), {random.uniform(0.0, 400.0), 50.0});
        expect_same_interior(points, "thin");
    }
}

TEST(Interior, scan_line_equals_flood_fill_with_nodes_and_segments_exactly_on_sites) {
    Random random(3);
    for (int trial = 0; trial < 300; ++trial) {
        // Half-integer corners put nodes on sites and segments along lines of sites.
        const double half = 0.5 * std::floor(random.uniform(2.0, 24.0));
        const double high = 0.5 * std::floor(random.uniform(2.0, 24.0));
        const Vec2 corner{0.5 * std::floor(random.uniform(-9.0, 9.0)),
                          0.5 * std::floor(random.uniform(-9.0, 9.0))};
        const double tilt = std::floor(random.uniform(-3.0, 4.0));
        std::vector<Vec2> points{{0, 0},
                                 {half, tilt},
                                 {2 * half, 2 * tilt},
                                 {2 * half - tilt, 2 * tilt + high},
                                 {half - tilt, tilt + high},
                                 {-tilt, high}};
        expect_same_interior(placed(points, 0.0, corner), "lattice polygon");
        expect_same_interior(placed(biconcave(2.0 * half + 2.0, 60), 0.0, corner), "biconcave");
    }
}

TEST(Interior, every_site_is_judged_as_by_the_angle_the_outline_subtends) {
    Random random(4);
    for (int trial = 0; trial < 10; ++trial) {
        const auto points = random_cells::smooth_shape(random, 6.0, 40);
        const Patch patch = filled(ScanLine{}, points);
        for (int r = 0; r < patch.height; ++r) {
            for (int c = 0; c < patch.width; ++c) {
                const Vec2 site = Lattice::position(patch.i + c, patch.j + r);
                double angle = 0.0;
                for (std::size_t k = 0; k < points.size(); ++k) {
                    const Vec2 a = points[k] - site;
                    const Vec2 b = points[(k + 1) % points.size()] - site;
                    angle += std::atan2(cross(a, b), dot(a, b));
                }
                EXPECT_EQ(patch.row(r)[c], std::round(angle / (2.0 * std::numbers::pi)));
            }
        }
    }
}

TEST(AreaFraction, sums_to_the_area_of_the_polygon) {
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        auto points = random_cells::smooth_shape(random, random.uniform(2.0, 25.0), 126, 0.1);
        points = placed(points, 0.0, {random.uniform(-900.0, 900.0), random.uniform(0.0, 100.0)});
        const Patch patch =
            filled([](const LocalOutline& o, Patch& p) { AreaFraction::cover(o, p); }, points);
        // area_of loses digits far from the origin; seen from node 0 the same polygon has the same
        // area.
        EXPECT_NEAR(sum(patch) / area_of(placed(points, 0.0, -points[0])), 1.0, 1e-12);
    }
}

TEST(AreaFraction, of_a_tilted_half_plane_is_that_of_the_cut_square) {
    // A big triangle whose edge y = x/2 + 3.25 cuts squares at known places.
    const std::vector<Vec2> points{{0.0, 3.25}, {0.0, 0.0}, {20.0, 0.0}, {20.0, 13.25}};
    const Patch patch =
        filled([](const LocalOutline& o, Patch& p) { AreaFraction::cover(o, p); }, points);
    const auto at = [&](int i, int j) { return patch.row(j - patch.j)[i - patch.i]; };
    EXPECT_NEAR(at(0, 3), 0.5, 1e-15);  // from 0.25 to 0.75 of its height
    EXPECT_NEAR(at(1, 3), 1.0 - 0.25 * 0.5 * 0.5,
                1e-15);  // a corner triangle ½ wide and ¼ high is missing
    EXPECT_NEAR(at(1, 4), 0.5 * 0.5 * 0.25, 1e-15);
    EXPECT_NEAR(at(10, 2), 1.0, 1e-15);
    EXPECT_NEAR(at(10, 14), 0.0, 1e-15);
}

TEST(Rates, of_a_viscosity_are_those_of_its_relaxation_times) {
    for (const double viscosity : {0.01, 1.0 / 6.0, 2.5}) {
        const Rates trt = Trt{}.rates(viscosity);
        EXPECT_DOUBLE_EQ(trt.even, even_rate(viscosity));
        EXPECT_NEAR(trt.odd, Trt{}.odd_rate(trt.even), 1e-14);
        EXPECT_EQ(Bgk{}.rates(viscosity).odd, even_rate(viscosity));
    }
}

TEST(SmoothedInterface, of_a_flat_membrane_is_the_step_function_of_the_distance) {
    const std::vector<Vec2> points{{0.0, 0.0},   {20.0, 0.0},  {40.0, 0.0},
                                   {40.0, 20.3}, {20.0, 20.3}, {0.0, 20.3}};
    std::vector<double> x, y;
    Patch patch;
    LocalOutline local;
    const SmoothedInterface interface { 2.0 };
    ASSERT_TRUE(lay_patch(as_outline(points, x, y), interface.reach(), 1e4, patch, local));
    interface(ScanLine{}, local, patch);
    for (int j = 10; j < 24; ++j) {
        const double s = std::clamp((20.3 - (j + 0.5)) / 2.0, -1.0, 1.0);
        const double step = 0.5 + (15 * s - 10 * s * s * s + 3 * std::pow(s, 5)) / 16;
        if (j - patch.j < patch.height) {
            EXPECT_NEAR(patch.row(j - patch.j)[20 - patch.i], step, 1e-14) << j;
        }
    }
}

ViscosityModel model_with(InterfaceViscosity interface, InteriorMethod interior = ScanLine{}) {
    ViscosityModel model;
    model.interior = interior;
    model.interface = interface;
    model.cytoplasm = {5.0 / 6.0};
    model.refresh_distance = 0.0;
    return model;
}

bool same_bits(const Field<>& a, const Field<>& b) {
    const Lattice& lattice = a.lattice();
    for (int j = 0; j < lattice.ny; ++j)
        if (std::memcmp(a.row(j), b.row(j), sizeof(double) * lattice.nx) != 0) return false;
    return true;
}

const InterfaceViscosity interfaces[] = {SharpInterface{}, SmoothedInterface{2.0},
                                         SmoothedInterface{0.7}, AreaFraction{}};

/// Moves cells for some steps, updating with `threads`; the fields must equal those made from
/// scratch.
void expect_update_equals_rebuild(Lattice lattice, const ViscosityModel& model, int threads,
                                  double step) {
    Suspension cells = random_cells::suspension(7, 4, 3, 30.0, 11.0, 70);
    for (int c = 0; c < cells.cell_count(); ++c)
        cells.kind[c] = c % static_cast<int>(model.cytoplasm.size());
    Random random(8);
    InteriorState interior, fresh;
    Relaxation relaxation(lattice), fresh_relaxation(lattice);
    rebuild_viscosity(model, cells, interior, relaxation);
    for (int n = 0; n < 6; ++n) {
        random_cells::jiggle(cells, random, step);
        with_team(threads, [&] {
            lay_cytoplasm(model, cells, interior);
            team_barrier();
            update_viscosity(model, cells, interior, relaxation);
        });
        fresh.x = interior.x;
        fresh.y = interior.y;
        restore_viscosity(model, cells, fresh, fresh_relaxation);
        ASSERT_TRUE(same_bits(interior.cytoplasm, fresh.cytoplasm));
        ASSERT_TRUE(same_bits(relaxation.even, fresh_relaxation.even));
        ASSERT_TRUE(same_bits(relaxation.odd, fresh_relaxation.odd));
    }
}

TEST(Viscosity, update_gives_the_bits_of_rebuild_after_random_moves_with_any_team) {
    for (const InterfaceViscosity& interface : interfaces) {
        for (const int threads : {1, 2, 5}) {
            expect_update_equals_rebuild({120, 91, true}, model_with(interface), threads, 0.11);
            expect_update_equals_rebuild({120, 91, false}, model_with(interface), threads, 0.02);
        }
    }
    ViscosityModel late = model_with(SmoothedInterface{});
    late.refresh_distance = 0.5;
    late.mean = HarmonicMean{};
    late.collision = Bgk{};
    late.layer_thickness = 20.4;
    late.layer_viscosity = 1.0;
    expect_update_equals_rebuild({120, 91, true}, late, 3, 0.03);
}

TEST(Viscosity, cells_may_be_longer_than_the_box) {
    for (const InterfaceViscosity& interface : interfaces)
        expect_update_equals_rebuild({17, 91, true}, model_with(interface), 2, 0.05);
}

TEST(Viscosity, does_not_depend_on_which_period_a_cell_is_in) {
    const Lattice lattice{64, 48, true};
    for (const InterfaceViscosity& interface : interfaces) {
        std::vector<InteriorState> interior(2);
        for (const int periods : {0, 7}) {
            Suspension cells;
            add_cell(cells, placed(circle(9.125, 60), 0.25, {60.0 + 64.0 * periods, 20.0}));
            // Positions a period apart must have the same bits relative to it, so they are rounded
            // first.
            for (double& x : cells.x)
                x = std::round((x - 64.0 * periods) * 0x1p30) * 0x1p-30 + 64.0 * periods;
            Relaxation relaxation(lattice);
            rebuild_viscosity(model_with(interface), cells, interior[periods ? 1 : 0], relaxation);
        }
        EXPECT_TRUE(same_bits(interior[0].cytoplasm, interior[1].cytoplasm));
    }
}

TEST(Viscosity, is_plasma_outside_and_cytoplasm_inside) {
    const Lattice lattice{64, 48, true};
    Suspension cells;
    add_cell(cells, placed(circle(10.0, 64), 0.0, {63.0, 24.0}));
    for (const InterfaceViscosity& interface : interfaces) {
        InteriorState interior;
        Relaxation relaxation(lattice);
        const ViscosityModel model = model_with(interface);
        rebuild_viscosity(model, cells, interior, relaxation);
        EXPECT_EQ(interior.cytoplasm(62, 24), 1.0);
        EXPECT_EQ(interior.cytoplasm(3, 24), 1.0);  // across the periodic end
        EXPECT_EQ(interior.cytoplasm(32, 24), 0.0);
        EXPECT_DOUBLE_EQ(relaxation.even(62, 24), even_rate(model.cytoplasm[0]));
        EXPECT_DOUBLE_EQ(relaxation.even(32, 24), even_rate(model.plasma));
        EXPECT_DOUBLE_EQ(relaxation.odd(32, 24), Trt{}.odd_rate(even_rate(model.plasma)));
    }
}

TEST(Viscosity, of_several_kinds_is_updated_as_it_is_rebuilt) {
    for (const ViscosityMean mean :
         {ViscosityMean{HarmonicMean{}}, ViscosityMean{ArithmeticMean{}}}) {
        ViscosityModel model = model_with(AreaFraction{});
        model.mean = mean;
        model.cytoplasm = {5.0 / 6.0, 0.3, 1.0 / 6.0, 0.05};  // plasma has 1/6
        expect_update_equals_rebuild({128, 96, true}, model, 1, 0.3);
        expect_update_equals_rebuild({128, 96, true}, model, 2, 0.3);
    }
}

TEST(Viscosity, of_each_kind_is_that_of_a_model_with_this_kind_alone) {
    const Lattice lattice{96, 48, true};
    const std::vector<double> viscosities{5.0 / 6.0, 0.3, 1.0 / 6.0, 0.05};
    for (const ViscosityMean mean :
         {ViscosityMean{HarmonicMean{}}, ViscosityMean{ArithmeticMean{}}})
        for (std::size_t k = 0; k < viscosities.size(); ++k) {
            Suspension cells;
            add_cell(cells, placed(circle(10.0, 64), 0.0, {30.3, 24.2}), static_cast<int>(k));
            ViscosityModel several = model_with(AreaFraction{}), alone = several;
            several.mean = alone.mean = mean;
            several.cytoplasm = viscosities;
            alone.cytoplasm = {viscosities[k]};
            InteriorState interior;
            Relaxation of_several(lattice), of_one(lattice);
            rebuild_viscosity(several, cells, interior, of_several);
            const Field fraction = fraction_inside(interior);
            cells.kind[0] = 0;
            rebuild_viscosity(alone, cells, interior, of_one);
            EXPECT_TRUE(same_bits(fraction, interior.cytoplasm));
            for (int j = 0; j < lattice.ny; ++j)
                for (int i = 0; i < lattice.nx; ++i)
                    ASSERT_NEAR(of_several.even(i, j), of_one.even(i, j), 2e-11) << i << " " << j;
        }
}

TEST(Viscosity, a_cell_is_laid_anew_only_when_a_node_has_moved_far_enough) {
    const Lattice lattice{64, 48, true};
    Suspension cells;
    add_cell(cells, placed(circle(10.0, 64), 0.0, {30.0, 24.0}));
    ViscosityModel model = model_with(AreaFraction{});
    model.refresh_distance = 0.1;
    InteriorState interior;
    Relaxation relaxation(lattice);
    rebuild_viscosity(model, cells, interior, relaxation);
    const Field before = interior.cytoplasm;
    cells.x[5] += 0.09;
    lay_cytoplasm(model, cells, interior);
    update_viscosity(model, cells, interior, relaxation);
    EXPECT_TRUE(same_bits(before, interior.cytoplasm));
    cells.x[5] += 0.02;
    lay_cytoplasm(model, cells, interior);
    update_viscosity(model, cells, interior, relaxation);
    EXPECT_FALSE(same_bits(before, interior.cytoplasm));
    EXPECT_EQ(interior.x, cells.x);
}

TEST(Viscosity, of_a_moving_cell_neither_lags_nor_leads_on_average) {
    const Lattice lattice{64, 48, true};
    Suspension cells;
    add_cell(cells, placed(circle(10.0, 64), 0.0, {20.0, 24.0}));
    ViscosityModel model = model_with(AreaFraction{});
    model.refresh_distance = 0.1;
    InteriorState interior;
    Relaxation relaxation(lattice);
    rebuild_viscosity(model, cells, interior, relaxation);
    const int steps = 400;
    double lag = 0.0;
    for (int step = 0; step < steps; ++step) {
        for (int n = 0; n < cells.node_count(); ++n) cells.x[n] += cells.ux[n] = 0.03;
        lay_cytoplasm(model, cells, interior);
        update_viscosity(model, cells, interior, relaxation);
        lag += cells.x[0] - interior.x[0];
        EXPECT_LE(std::abs(cells.x[0] - interior.x[0]), model.refresh_distance + 1e-12);
    }
    EXPECT_LT(std::abs(lag / steps), 0.02);
}

TEST(Viscosity, keeps_the_last_good_field_when_positions_are_not_finite) {
    const Lattice lattice{64, 48, true};
    for (const double bad : {std::nan(""), HUGE_VAL, 1e300, -1e12}) {
        Suspension cells;
        add_cell(cells, placed(circle(10.0, 64), 0.0, {30.0, 24.0}));
        const ViscosityModel model = model_with(AreaFraction{});
        InteriorState interior;
        Relaxation relaxation(lattice);
        rebuild_viscosity(model, cells, interior, relaxation);
        const Field before = interior.cytoplasm;
        cells.y[7] = bad;
        lay_cytoplasm(model, cells, interior);
        update_viscosity(model, cells, interior, relaxation);
        EXPECT_TRUE(same_bits(before, interior.cytoplasm));
    }
}

TEST(Viscosity, of_the_row_cut_by_a_layer_is_the_harmonic_mean) {
    const Lattice lattice{8, 10, true};
    ViscosityModel model;
    model.layer_thickness = 4.25;
    model.layer_viscosity = 1.0;
    InteriorState interior;
    Relaxation relaxation(lattice);
    rebuild_viscosity(model, Suspension{}, interior, relaxation);
    EXPECT_DOUBLE_EQ(relaxation.even(3, 3), even_rate(1.0));
    EXPECT_DOUBLE_EQ(relaxation.even(3, 4), even_rate(1.0 / (0.25 / 1.0 + 0.75 * 6.0)));
    EXPECT_DOUBLE_EQ(relaxation.even(3, 5), even_rate(1.0 / 6.0));
}

}  // namespace
