#include "case/step_limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/appraise.hpp"
#include "case/choose.hpp"
#include "case/contact_at_start.hpp"
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
        return word_of(choice_of(name, {change}).precision);
    };
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.step_tolerance=1 %"), "single");
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.step_tolerance=0.99 %"), "double");
    EXPECT_EQ(precision("03-cell-in-shear", "numerics.precision=double"), "double");
    EXPECT_EQ(precision("01-poiseuille", "numerics.step_tolerance=1 %"), "double");
}

/// e^{2 β r0} of the largest distance that can be written is no number any more.
TEST(ContactAtStart, that_would_burst_cells_is_refused_with_a_distance_that_helps) {
    const auto why = [](const std::vector<std::string>& changes) {
        const Case c = read_case(TT_SOURCE_DIR "/cases/05-channel/case.toml", changes);
        const Model model = discretise(c, choose(c));
        return bursting_contact(c, model, initial_state(c, model)).value_or("");
    };
    EXPECT_EQ(why({}), "");
    for (const char* distance : {"100 um", "3 um"}) {
        const std::string told = why({fmt::format("contact.zero_force_distance={}", distance)});
        const std::size_t at = told.find("zero_force_distance = \"") + 23;
        ASSERT_LT(at, told.size()) << told;
        const std::string advised = told.substr(at, told.find('"', at) - at);
        EXPECT_EQ(why({"contact.zero_force_distance=" + advised}), "") << advised;
    }
}

TEST(ContactAtStart, a_repulsion_longer_than_a_cell_is_refused_with_a_range_that_is_not) {
    const auto read = [](const std::string& range) {
        return read_case(
            TT_SOURCE_DIR "/cases/05-channel/case.toml",
            {"contact.short_range_repulsion=true", "contact.repulsion_range=" + range});
    };
    try {
        read("1 mm");
        FAIL() << "it was taken";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("write repulsion_range = \"0.2 um\""),
                  std::string::npos)
            << error.what();
    }
    EXPECT_NO_THROW(read("0.2 um"));
}

TEST(StepLimits, of_the_default_tolerance_are_the_documented_ones) {
    const Choice shear = choice_of("03-cell-in-shear", {"numerics.relaxation_time=1.5"});
    EXPECT_EQ(shear.limits.front().name, "Reynolds number");
    EXPECT_NEAR(shear.density_scale * 1025.0 * 250.0 * 16e-12 / 1.2e-3, 0.2, 1e-9);
    EXPECT_NEAR(shear.expected_change(), 0.01, 1e-12);

    const Choice channel =
        choice_of("05-channel", {"numerics.step_tolerance=1 %", "numerics.relaxation_time=1.5"});
    EXPECT_NEAR(channel.density_scale * 1025.0 * 500.0 * 16e-12 / 1.2e-3, 0.035, 1e-9);
    // (τ − ½) V Δt/a with V = 3/2 U
    EXPECT_NEAR(15e-3 * step_of(channel, "stress delay") / 4e-6, 0.0025, 1e-12);
}

TEST(StepLimits, inertia_and_delay_meet_at_the_relaxation_time_of_the_longest_step) {
    const Choice one = choice_of("05-channel", {"numerics.step_tolerance=1 %"});
    // (τ − ½)² = delay limit a/V over S ρ h²/(3 μ) with S ρ k a²/μ = 0.035.
    EXPECT_NEAR(one.relaxation_time,
                0.5 + std::sqrt(0.0025 * 4e-6 / 15e-3 * 3.0 * 500.0 * 16e-12 / (0.035 * 4e-14)),
                0.005);
    EXPECT_NEAR(step_of(one, "stress delay") / step_of(one, "Reynolds number"), 1.0, 0.005);
    EXPECT_NEAR(one.expected_change(), 0.01, 1e-12);
    EXPECT_GT(one.dt.si, 3.3 * choice_of("05-channel", {"numerics.step_tolerance=1 %",
                                                        "numerics.relaxation_time=1.5"})
                                   .dt.si);

    // Few sites to a radius: stress delay is the first even at 1.5.
    const std::vector<std::string> coarse{"numerics.dx=0.8 um", "numerics.step_tolerance=1 %"};
    EXPECT_LT(choice_of("05-channel", coarse).relaxation_time, 1.5);
}

TEST(StepLimits, allow_no_longer_step_at_any_other_relaxation_time) {
    for (const char* name : {"03-cell-in-shear", "04-cell-relaxing", "05-channel"})
        for (const char* tolerance : {"1 %", "5 %"}) {
            const std::string tolerated = std::string("numerics.step_tolerance=") + tolerance;
            const Choice chosen = choice_of(name, {tolerated});
            for (const char* tau : {"1", "1.3", "1.5", "1.7", "2", "2.4", "3", "3.5", "4"}) {
                const Choice other =
                    choice_of(name, {tolerated, std::string("numerics.relaxation_time=") + tau});
                EXPECT_LE(other.dt.si, chosen.dt.si) << name << " " << tolerance << " " << tau;
            }
        }
}

TEST(StepLimits, of_stability_leave_the_relaxation_time_as_small_as_the_step_allows) {
    EXPECT_EQ(choice_of("01-poiseuille", {}).relaxation_time, 1.5);  // Mach alone
    const Choice channel = choice_of("05-channel", {});
    EXPECT_NEAR(step_of(channel, "Reynolds number") / channel.dt.si, 1.0, 0.01);
}

TEST(Choice, of_the_relaxation_time_does_not_depend_on_a_step_or_density_scale_that_is_given) {
    const double tau = choice_of("05-channel", {}).relaxation_time;
    const Choice step = choice_of("05-channel", {"numerics.dt=0.1 us"});
    EXPECT_EQ(step.relaxation_time, tau);
    EXPECT_EQ(step.dt.si, 1e-7);
    const Choice scale = choice_of("05-channel", {"numerics.density_scale=10"});
    EXPECT_EQ(scale.relaxation_time, tau);
    EXPECT_DOUBLE_EQ(scale.density_scale, 10.0);
}

/// Gaps are measured less often than nodes move, where contact is soft enough.
TEST(Discretise, measures_contact_every_four_steps_unless_it_is_stiff) {
    const auto interval = [](const std::vector<std::string>& changes) {
        return discretise(read_case(TT_SOURCE_DIR "/cases/05-channel/case.toml", changes))
            .contact.interval;
    };
    EXPECT_EQ(interval({}), 4);
    EXPECT_EQ(interval({"flow.pseudo_shear_rate=50 /s"}), 4);
    EXPECT_EQ(interval({"contact.energy=0 J/m^2"}), 4);
    EXPECT_EQ(interval({"contact.energy=1.3e-4 J/m^2"}), 1);
    EXPECT_EQ(interval({"contact.short_range_repulsion=true"}), 1);
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
                                        "numerics.implicit_tension=false",
                                        "flow.shear_number=0.05",
                                        "cells.cytoplasm_viscosity=1.2 cP",
                                        "membrane.hardening.apply_to=shear,bending,area,contact",
                                        "membrane.hardening.D=0.55",
                                        "membrane.hardening.beta=16"};

TEST(StepLimits, know_that_a_hardened_membrane_is_stiffer_when_stretched) {
    // This cell came to a stretch of 1.055; it ran with 10 µs and blew up with 13.3 µs.
    const Choice choice = choice_of("03-cell-in-shear", hardened);
    EXPECT_EQ(choice.limits.front().name, "membrane tension");
    EXPECT_GT(choice.kinds[0].expected_stretch, 1.055);
    EXPECT_LT(choice.dt.si, 10e-6);
    EXPECT_GT(choice.dt.si, 4e-6);

    std::vector<std::string> given = hardened;
    given.emplace_back("numerics.dt=13.3 us");
    const Case c = read_case(TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml", given);
    const Choice stated = choose(c);
    const Model model = discretise(c, stated);
    EXPECT_TRUE(appraise(c, stated, model, initial_state(c, model)).refused());
}

TEST(StepLimits, of_a_rigid_body_at_rest_do_not_hold_back_the_cells_beside_it) {
    const std::string rest = R"(format = 1
[domain]
length = "40 um"
width = "40 um"
[cells]
layout = "random"
count = 2
radius = "3 um"
[time]
end = "1 ms"
[[kind]]
name = "red"
count = 1
[[kind]]
name = "bead"
count = 1
rigid = )";
    const Choice soft = choose(parse_case(rest + "false\n", "case.toml"));
    const Choice rigid = choose(parse_case(rest + "true\n", "case.toml"));
    EXPECT_EQ(rigid.limits.front().name, soft.limits.front().name);
    EXPECT_EQ(rigid.dt, soft.dt);
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
