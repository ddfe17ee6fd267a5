#include "case/step_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/appraise.hpp"
#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/membrane_of.hpp"
#include "case/read.hpp"
#include "membrane/stability.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

Choice choice_of(const std::string& name, const std::vector<std::string>& changes) {
    return choose(read_case(TT_SOURCE_DIR "/cases/" + name + "/case.toml", changes));
}

double step_of(const Choice& choice, const std::string& limit) {
    for (const StepLimit& l : choice.limits)
        if (l.name == limit) return l.step.si;
    return 0.0;
}

TEST(Choice, the_kernel_of_ten_times_the_viscosity_is_that_of_the_documents) {
    const auto delta = [](const std::string& cytoplasm) {
        return word_of(choice_of("03-cell-in-shear", {"plasma.viscosity=1.2 cP",
                                                      "cells.cytoplasm_viscosity=" + cytoplasm})
                           .delta);
    };
    EXPECT_EQ(delta("12 cP"), "roma3");
    EXPECT_EQ(delta("0.12 cP"), "roma3");
    EXPECT_EQ(delta("12.01 cP"), "peskin4");
}

TEST(Choice, single_precision_is_for_cells_and_tolerances_of_a_percent) {
    const auto precision = [](const char* name, const char* change) {
        return choice_of(name, {change}).precision;
    };
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.step_tolerance=1 %"), Precision::fp32);
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.step_tolerance=0.99 %"), Precision::fp64);
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.precision=double"), Precision::fp64);
    EXPECT_EQ(precision("01-poiseuille", "numerics.step_tolerance=1 %"), Precision::fp64);
}

TEST(StepLimits, of_the_default_tolerance_are_the_documented_ones) {
    const Choice shear = choice_of("03-cell-in-shear", {});
    EXPECT_EQ(shear.limits.front().name, "Reynolds number");
    EXPECT_NEAR(shear.density_scale * 1025.0 * 250.0 * 16e-12 / 1.2e-3, 0.2, 1e-9);
    EXPECT_NEAR(shear.expected_change(), 0.01, 1e-12);

    const Choice channel = choice_of("05-channel", {"numerics.step_tolerance=1 %"});
    EXPECT_NEAR(channel.density_scale * 1025.0 * 500.0 * 16e-12 / 1.2e-3, 0.035, 1e-9);
    // (τ − ½) V Δt/a with V = 3/2 U
    EXPECT_NEAR(15e-3 * step_of(channel, "stress delay") / 4e-6, 0.0025, 1e-12);
}

TEST(StepLimits, a_tighter_tolerance_gives_a_smaller_step_and_a_looser_one_stays_stable) {
    for (const char* name : {"03-cell-in-shear", "05-channel"}) {
        double before = 0.0;
        for (const char* tolerance : {"0.02 %", "0.1 %", "0.5 %", "1 %", "3 %", "20 %"}) {
            const Choice choice =
                choice_of(name, {std::string("numerics.step_tolerance=") + tolerance});
            EXPECT_GE(choice.dt.si, before) << name << " " << tolerance;
            if (choice.limits.front().change > 0.0 && choice.density_scale > 1.0) {
                EXPECT_GT(choice.dt.si, before);
            }
            EXPECT_LE(choice.dt.si, step_of(choice, "Mach number"));
            EXPECT_LE(choice.dt.si, step_of(choice, "membrane tension"));
            before = choice.dt.si;
        }
    }
}

TEST(StepLimits, never_ask_for_less_than_the_physical_reynolds_number) {
    const Choice choice = choice_of("03-cell-in-shear", {"numerics.step_tolerance=0.01 %"});
    EXPECT_DOUBLE_EQ(choice.density_scale, 1.0);
}

TEST(StepLimits, of_equilibria_that_feel_inertia_where_it_should_not_be_are_tighter) {
    const auto step = [](const char* name, const char* equilibrium) {
        return choice_of(name, {std::string("numerics.equilibrium=") + equilibrium}).dt.si;
    };
    EXPECT_LT(step("03-cell-in-shear", "incompressible"), step("03-cell-in-shear", "linear"));
    EXPECT_LT(step("05-channel", "linear"), step("05-channel", "incompressible"));
    EXPECT_LE(step("05-channel", "full"), step("05-channel", "incompressible"));
}

const std::vector<std::string> hardened{"numerics.dx=0.4 um",
                                        "flow.shear_number=0.05",
                                        "cells.cytoplasm_viscosity=1.2 cP",
                                        "membrane.hardening.apply_to=shear,bending,area,contact",
                                        "membrane.hardening.D=0.55",
                                        "membrane.hardening.beta=16"};

TEST(StepLimits, know_that_a_hardened_membrane_is_stiffer_when_stretched) {
    // This cell came to a stretch of 1.055; it ran with 10 µs and blew up with 13.3 µs.
    const Choice choice = choice_of("03-cell-in-shear", hardened);
    EXPECT_EQ(choice.limits.front().name, "membrane tension");
    EXPECT_GT(choice.expected_stretch, 1.055);
    EXPECT_LT(choice.dt.si, 10e-6);
    EXPECT_GT(choice.dt.si, 4e-6);

    std::vector<std::string> given = hardened;
    given.emplace_back("numerics.dt=13.3 us");
    const Case c = read_case(TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml", given);
    const Choice stated = choose(c);
    const Model model = discretise(c, stated);
    EXPECT_TRUE(appraise(c, stated, model, initial_state(c, model)).refused());
}

TEST(Stability, slope_and_stretch_are_those_of_the_hardened_law) {
    Membrane membrane;
    membrane.in_plane = NeoHookean{2.0};
    EXPECT_NEAR(tension_slope(membrane, 1.0), 6.0, 1e-6);
    EXPECT_NEAR(stretch_at(membrane, NeoHookean{2.0}.tension(1.2)), 1.2, 1e-12);
    membrane.hardening = {Hardening::Form::exponential, Hardening::Compression::symmetric, 0.55,
                          16.0, true};
    const auto hard = [&](double stretch) {
        return NeoHookean{2.0}.tension(stretch) * membrane.hardening(stretch);
    };
    EXPECT_NEAR(tension_slope(membrane, 1.1), (hard(1.1 + 1e-5) - hard(1.1 - 1e-5)) / 2e-5, 1e-6);
    EXPECT_NEAR(stretch_at(membrane, hard(1.15)), 1.15, 1e-12);
    EXPECT_EQ(stretch_at(membrane, 0.0), 1.0);
    membrane.in_plane = SurfaceTension{2.0};
    membrane.hardening = {};
    EXPECT_EQ(tension_slope(membrane, 1.5), 2.0);
}

}  // namespace
}  // namespace tt
