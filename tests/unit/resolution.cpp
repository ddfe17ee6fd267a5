#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/appraise.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

Appraisal appraised(const std::string& name, const std::vector<std::string>& changes) {
    const Case c = read_case(TT_SOURCE_DIR "/cases/" + name + "/case.toml", changes);
    const Choice choice = choose(c);
    const Model model = discretise(c, choice);
    return appraise(c, choice, model, initial_state(c, model));
}

/// The dx that an advice about `what` asks for; empty where there is none.
std::string asked_dx(const Appraisal& a, const std::string& what) {
    for (const Advice& advice : a.advice) {
        if (advice.text.find(what) == std::string::npos) continue;
        const std::size_t at = advice.text.find("dx = \"") + 6;
        return advice.text.substr(at, advice.text.find('"', at) - at);
    }
    return "";
}

std::vector<std::string> crumpling(const std::string& dx) {
    return {"cells.shape=biconcave", "cells.layout=random",
            "cells.count=40",        "domain.width=60 um",
            "domain.length=32 um",   "flow.pseudo_shear_rate=1000 /s",
            "membrane.law=skalak",   "membrane.area_dilation_ratio=10",
            "numerics.dx=" + dx};
}

TEST(Resolution, too_many_sites_are_made_fewer_without_losing_the_cells) {
    const auto advice = [](const std::vector<std::string>& changes, double most) -> std::string {
        const Case c = read_case(TT_SOURCE_DIR "/cases/05-channel/case.toml", changes);
        try {
            expect_sites(c, choose(c), most, "are possible");
        } catch (const CaseError& error) {
            const std::string text = error.what();
            return text.substr(text.rfind("write ") + 6);
        }
        return "";
    };
    EXPECT_EQ(advice({}, 40'000), "");
    EXPECT_EQ(advice({}, 20'000), "dx = \"0.4 um\"");
    EXPECT_EQ(advice({}, 1000), "length = \"2 um\"") << "16 sites to a cell's diameter are too few";
    EXPECT_EQ(advice({"cells.layout=single", "cells.count=1", "domain.width=1 cm",
                      "domain.length=20 um", "flow.pseudo_shear_rate=1 /s"},
                     1e5),
              "width = \"200 um\"");
}

TEST(Resolution, cells_that_are_next_to_empty_are_refused_with_a_viscosity_that_is_not) {
    const Appraisal thin =
        appraised("05-channel", {"plasma.viscosity=1e5 cP", "flow.pseudo_shear_rate=0.4 /s"});
    ASSERT_TRUE(thin.refused());
    const auto told = std::find_if(thin.advice.begin(), thin.advice.end(), [](const Advice& x) {
        return x.text.find("cytoplasm_viscosity = \"0.1 Pa s\"") != std::string::npos;
    });
    EXPECT_NE(told, thin.advice.end());
    const std::vector<std::string> thick{"plasma.viscosity=1e5 cP", "flow.pseudo_shear_rate=0.4 /s",
                                         "cells.cytoplasm_viscosity=100 cP"};
    EXPECT_FALSE(appraised("05-channel", thick).refused());
}

TEST(Resolution, what_the_grid_must_resolve_is_told_in_sites) {
    const Appraisal a = appraised("05-channel", {});
    EXPECT_NEAR(a.bending_length, std::sqrt(1.8e-19 / 6e-6) / 0.2e-6, 1e-9);
    EXPECT_NEAR(a.contact_distance, 0.49 / 0.2, 1e-9);
    EXPECT_NEAR(a.start_radius, 20.0, 0.1);
    EXPECT_NEAR(a.start_turn_deg, 360.0 / (a.nodes / a.cells), 1e-6);
}

TEST(Resolution, membranes_that_buckle_below_the_grid_are_told_with_a_spacing_that_helps) {
    const Appraisal coarse = appraised("05-channel", crumpling("0.4 um"));
    EXPECT_NEAR(coarse.bending_length, 0.433, 0.001);
    const std::string dx = asked_dx(coarse, "bending length");
    ASSERT_NE(dx, "");
    const Appraisal fine = appraised("05-channel", crumpling(dx));  // it divides the box
    EXPECT_EQ(asked_dx(fine, "bending length"), "") << dx;
    EXPECT_GT(fine.bending_length, 0.63);
}

TEST(Resolution, a_shape_that_the_nodes_cannot_follow_is_told_with_a_spacing_that_helps) {
    // Drawn out to an axis ratio of 3, a circle of 4 sites has tips of 4/(3 √3) sites' radius.
    const auto drawn_out = [](const std::string& dx) {
        return appraised("04-cell-relaxing", {"cells.initial_stretch=3", "numerics.dx=" + dx});
    };
    const std::string dx = asked_dx(drawn_out("1 um"), "shape at the start");
    ASSERT_NE(dx, "");
    EXPECT_EQ(asked_dx(drawn_out(dx), "shape at the start"), "");
}

TEST(Resolution, cases_that_come_with_the_program_have_no_such_advice) {
    for (const char* name : {"03-cell-in-shear", "04-cell-relaxing", "05-channel"}) {
        const Appraisal a = appraised(name, {});
        EXPECT_EQ(asked_dx(a, "bending length"), "") << name;
        EXPECT_EQ(asked_dx(a, "shape at the start"), "") << name;
    }
}

}  // namespace
}  // namespace tt
