#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "simulation/advance.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

struct Measured {
    double taylor = 0.0, strain = 0.0, lambda = 0.0, viscosity = 0.0;
};

/// The case at `share` of the step that auto takes, all else the same, over the last quarter of
/// `strained` times 1/k.
Measured run(const std::string& name, const std::vector<std::string>& changes, double share,
             double strained) {
    const Case c = read_case(TT_SOURCE_DIR "/cases/" + name + "/case.toml", changes);
    Choice choice = choose(c);
    choice.dt = Time{share * choice.dt.si};
    choice.density_scale *= share;
    const Model model = discretise(c, choice);
    State state = initial_state(c, model);
    Periodic ends;
    const auto last = std::llround(strained / (choice.shear_rate.si * choice.dt.si));
    const auto every = last / 80;
    Measured mean;
    for (int look = 1; look <= 80; ++look) {
        while (state.step < look * every) advance(model, state, ends);
        if (look <= 60) continue;
        const RunMeasures m = measure_run(model, state, measure_cells(model, state));
        mean.taylor += m.taylor_inertia / 20.0;
        mean.strain += m.strain / 20.0;
        mean.viscosity += m.mu_rel / 20.0;
    }
    mean.lambda = 1.0 + mean.strain;
    return mean;
}

void expect_within(const char* what, double at_auto, double at_a_quarter, double tolerance) {
    const double change = at_auto / at_a_quarter - 1.0;
    fmt::print("{:<8} {:.5f} with the step of auto, {:.5f} with a quarter: {:+.2f} %\n", what,
               at_auto, at_a_quarter, 100.0 * change);
    EXPECT_LT(std::fabs(change), tolerance) << what;
}

TEST(TimeStep, of_auto_changes_a_cell_in_shear_by_less_than_the_tolerance) {
    const std::vector<std::string> coarse{"domain.length=40 um", "domain.width=20 um",
                                          "numerics.dx=0.8 um"};
    const Measured whole = run("03-cell-in-shear", coarse, 1.0, 8.0);
    const Measured quarter = run("03-cell-in-shear", coarse, 0.25, 8.0);
    expect_within("D", whole.taylor, quarter.taylor, 0.01);
    expect_within("strain", whole.strain, quarter.strain, 0.01);
}

TEST(TimeStep, of_auto_changes_a_cell_on_its_way_to_the_middle_of_a_channel_by_less) {
    const std::vector<std::string> row{
        "domain.length=16 um",         "numerics.dx=0.8 um",
        "cells.layout=explicit",       "cells.count=1",
        "numerics.step_tolerance=1 %", "cells.positions=[[\"8 um\", \"6.5 um\"]]"};
    const Measured whole = run("05-channel", row, 1.0, 12.0);
    const Measured quarter = run("05-channel", row, 0.25, 12.0);
    expect_within("D", whole.taylor, quarter.taylor, 0.01);
    expect_within("strain", whole.strain, quarter.strain, 0.01);
    expect_within("lambda_C", whole.lambda, quarter.lambda, 0.01);
    expect_within("mu_rel", whole.viscosity, quarter.viscosity, 0.01);
}

TEST(TimeStep, of_auto_keeps_a_hardened_cell_stable) {
    const std::vector<std::string> hardened{
        "domain.length=40 um",
        "numerics.dx=0.4 um",
        "flow.shear_number=0.05",
        "cells.cytoplasm_viscosity=1.2 cP",
        "membrane.hardening.apply_to=shear,bending,area,contact",
        "membrane.hardening.D=0.55",
        "membrane.hardening.beta=16"};
    const Measured m = run("03-cell-in-shear", hardened, 1.0, 3.0);
    fmt::print("hardened D {:.4f}, strain {:.4f}\n", m.taylor, m.strain);
    EXPECT_GT(m.strain, 0.01);
    EXPECT_LT(m.strain, 0.06);
}

}  // namespace
}  // namespace tt
