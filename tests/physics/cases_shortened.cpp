#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "fluid/analytic.hpp"
#include "observe/run_measures.hpp"
#include "observe/cell_measures.hpp"
#include "simulation/advance.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

/// A case that comes with the program, as `run` takes it, with what --set would change.
struct ShortenedCase {
    Model model;
    State state;
    Periodic ends;

    ShortenedCase(const std::string& name, const std::vector<std::string>& changes)
        : ShortenedCase(read_case(TT_SOURCE_DIR "/cases/" + name + "/case.toml", changes)) {}
    explicit ShortenedCase(const Case& c) : model(discretise(c)), state(initial_state(c, model)) {}

    /// Until this time [s].
    void until(double time) {
        const auto last = std::llround(time / model.scales.time);
        while (state.step < last) advance(model, state, ends);
    }
    RunMeasures measures() const { return measure_run(model, state, measure_cells(model, state)); }
    double area_error() const { return measures().area_error_max; }

    /// max |u − exact(y)| / max |exact(y)|, over all sites.
    template <class Exact>
    double profile_error(Exact exact) const {
        double worst = 0.0, largest = 0.0;
        for (int j = 0; j < model.lattice.ny; ++j) {
            const double u = exact(j + 0.5);
            largest = std::max(largest, std::abs(u));
            for (int i = 0; i < model.lattice.nx; ++i)
                worst = std::max(worst, std::abs(state.velocity(i, j).x - u));
        }
        return worst / largest;
    }
};

TEST(ShortenedCases, poiseuille_settles_to_the_parabola_of_the_nominal_rate) {
    ShortenedCase c("01-poiseuille", {"numerics.dx=1 um", "time.end=0.6 ms"});
    c.until(0.6e-3);
    const double height = c.model.lattice.ny;
    const double mean = 50.0 * 20e-6 * c.model.scales.time / c.model.scales.length;
    const double error =
        c.profile_error([&](double y) { return 6.0 * mean * (y / height) * (1.0 - y / height); });
    fmt::print("01-poiseuille, 20 sites, {} steps: error {:.1e}\n", c.state.step, error);
    EXPECT_LT(error, 1e-6);
}

TEST(ShortenedCases, two_layers_shear_in_two_straight_lines) {
    ShortenedCase c("02-two-layer-couette", {"numerics.dx=1 um", "time.end=2 ms"});
    c.until(2e-3);
    const double height = c.model.lattice.ny, half = 0.5 * height;
    const double wall = c.model.boundaries.top_speed;
    const double slope = wall / half / 3.0;  // of the lower layer, five times as viscous
    const double error = c.profile_error([&](double y) {
        return y < half ? -wall + slope * y : -wall + slope * half + 5.0 * slope * (y - half);
    });
    fmt::print("02-two-layer-couette, 20 sites, {} steps: error {:.1e}\n", c.state.step, error);
    EXPECT_LT(error, 1e-6);
}

TEST(ShortenedCases, cell_in_shear_deforms_ever_more_until_it_is_steady_and_leans_forward) {
    ShortenedCase c("03-cell-in-shear", {"domain.length=40 um", "numerics.dx=0.8 um"});
    double former = 0.0;
    for (const double time : {1e-3, 2e-3, 4e-3, 6e-3}) {
        c.until(time);
        const RunMeasures m = c.measures();
        fmt::print("03-cell-in-shear: D {:.4f} at {:g} ms\n", m.taylor_inertia, 1e3 * time);
        EXPECT_GT(m.taylor_inertia, former);
        EXPECT_GT(m.inclination_deg, 0.0);
        EXPECT_LT(m.inclination_deg, 45.0);
        former = m.taylor_inertia;
    }
    EXPECT_LT(c.area_error(), 1e-3);
}

TEST(ShortenedCases, stretched_cell_returns_to_its_circle_without_turning_back) {
    ShortenedCase c("04-cell-relaxing",
                    {"domain.length=20 um", "domain.width=20 um", "numerics.dx=0.8 um"});
    double former = c.measures().taylor_inertia;
    EXPECT_NEAR(former, 0.2, 1e-6);  // axis ratio 1.5
    for (int look = 1; look <= 6; ++look) {
        c.until(5e-3 * look);
        const double now = c.measures().taylor_inertia;
        EXPECT_LT(now, former) << 5 * look << " ms";
        former = now;
    }
    fmt::print("04-cell-relaxing: D {:.4f} at 30 ms, {} steps\n", former, c.state.step);
    EXPECT_LT(former, 0.16);  // slow: a neo-Hookean circle is soft in ellipses, ε ~ D²
    EXPECT_LT(c.area_error(), 1e-3);
}

TEST(ShortenedCases, cells_pass_a_stenosis_and_posts_keep_their_area_and_out_of_the_walls) {
    for (const char* name : {"06-stenosis", "08-posts"}) {
        ShortenedCase c(name, {"numerics.dx=0.5 um"});
        const double plasma_alone = c.measures().mean_velocity.si;
        c.until(6e-3);
        const RunMeasures m = c.measures();
        double nearest = 1.0;
        for (const CellMeasures& cell : measure_cells(c.model, c.state))
            nearest = std::min(nearest, cell.wall_distance.si);
        fmt::print("{}: area error {:.1e}, {:.2g} um from the walls, {} steps\n", name,
                   m.area_error_max, nearest * 1e6, c.state.step);
        EXPECT_NEAR(plasma_alone, std::string(name) == "06-stenosis" ? 2e-3 : 0.5e-3, 1e-5);
        EXPECT_LT(m.area_error_max, 1e-5);
        EXPECT_GT(nearest, 0.0);
        EXPECT_LT(m.mean_velocity.si, plasma_alone) << "cells resist the flow";
    }
}

class ShortenedChannel : public testing::TestWithParam<const char*> {};

TEST_P(ShortenedChannel, keeps_its_twelve_cells_their_areas_and_their_distance) {
    ShortenedCase c("05-channel", {std::string("membrane.hardening.apply_to=") + GetParam(),
                                   "numerics.dx=0.25 um"});
    const double plasma_alone = c.measures().pseudo_shear_rate.si;
    EXPECT_NEAR(plasma_alone, 500.0, 1.0);
    c.until(1e-3);
    const RunMeasures m = c.measures();
    fmt::print("05-channel, {}: area error {:.1e}, lambda_C {:.3f}, {:.0f} /s, {} steps\n",
               GetParam(), m.area_error_max, m.lambda_C, m.pseudo_shear_rate.si, c.state.step);
    EXPECT_EQ(measure_cells(c.model, c.state).size(), 12u);
    EXPECT_LT(m.area_error_max, 1e-5);
    EXPECT_GT(m.lambda_C, 1.05);
    EXPECT_LT(m.pseudo_shear_rate.si, plasma_alone) << "cells resist the flow";
    EXPECT_EQ(m.overlaps, 0);
}

TEST(ShortenedCases, channel_driven_by_pressure_starts_as_one_driven_by_a_body_force) {
    // With all of the drop at the ends when it starts, a wave of pressure would run to and fro, and
    // in a long channel tear the cells at the ends.
    std::vector<std::string> changes{"numerics.dx=0.5 um", "domain.length=320 um",
                                     "cells.count=48"};
    ShortenedCase by_pressure("05-channel", changes);
    changes.emplace_back("flow.drive=body-force");
    ShortenedCase by_force("05-channel", changes);
    by_pressure.until(0.05e-3);
    by_force.until(0.05e-3);
    double worst = 0.0, largest = 0.0;
    for (int j = 0; j < by_force.model.lattice.ny; ++j) {
        for (int i = 0; i < by_force.model.lattice.nx; ++i) {
            largest = std::max(largest, norm(by_force.state.velocity(i, j)));
            worst = std::max(
                worst, norm(by_pressure.state.velocity(i, j) - by_force.state.velocity(i, j)));
        }
    }
    fmt::print(
        "05-channel: pressure ends off body force by {:.1e} of the largest speed after {} "
        "steps\n",
        worst / largest, by_force.state.step);
    EXPECT_GT(by_force.state.step, 10);
    EXPECT_LT(worst, 6e-3 * largest);
}

INSTANTIATE_TEST_SUITE_P(CasesOneToThree, ShortenedChannel,
                         testing::Values("[]", "shear", "shear,bending,area,contact"));

}  // namespace
}  // namespace tt
