#include "case/trial.hpp"

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "command.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "simulation/stop.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Cases that no bound refuses and that blow up after some steps.
class Trial : public TemporaryDirectory {
protected:
    Trial() {
        replace_file(path("case.toml"), R"(format = 1
[domain]
length = "20 um"
width = "12 um"
[flow]
drive = "pressure"
pseudo_shear_rate = "200 /s"
[cells]
count = 1
radius = "2.7 um"
[numerics]
dx = "0.5 um"
[time]
end = "4 ms"
)",
                     Durability::process);
    }

    Outcome run_verb(std::vector<std::string> words, const std::vector<std::string>& changes) {
        words.insert(words.begin() + 1, path("case.toml").string());
        for (const std::string& change : changes) words.insert(words.end(), {"--set", change});
        return run(words);
    }
    Outcome run_with(const std::vector<std::string>& changes) {
        return run_verb({"run", "-o", path("o").string(), "-j", "1", "--progress", "none"},
                        changes);
    }
    Outcome check_with(const std::vector<std::string>& changes) {
        return run_verb({"check", "-j", "1", "--json"}, changes);
    }

    /// Refused with the same words by `check` and `run`, before anything is written; the words lead
    /// to a run.
    void expect_refused_with_a_cure(std::vector<std::string> changes) {
        const Outcome refused = run_with(changes);
        ASSERT_EQ(refused.code, 2) << refused.err;
        EXPECT_FALSE(fs::exists(path("o")));
        ASSERT_EQ(refused.err.find("A short try blew up at step "), 0u) << refused.err;
        EXPECT_EQ(refused.err, run_with(changes).err);
        const Outcome check = check_with(changes);
        EXPECT_EQ(check.code, 2);
        EXPECT_EQ(told(check), refused.err.substr(0, refused.err.find('\n')));

        const std::regex setting(R"re(--set ([\w.]+=(?:"[^"]*"|\S+)))re");
        const std::string& text = refused.err;
        for (std::sregex_iterator at(text.begin(), text.end(), setting), end; at != end; ++at)
            changes.push_back((*at)[1]);
        const Outcome cured = run_with(changes);
        EXPECT_EQ(cured.code, 0) << cured.err;
    }

private:
    static std::string told(const Outcome& check) {
        const Json all = Json::parse(check.out)["advice"];
        for (const Json& advice : all)
            if (advice["refused"].get<bool>()) return advice["text"].get<std::string>();
        return "";
    }
};

TEST_F(Trial, refuses_numerics_by_hand_that_blow_up_before_anything_is_written) {
    expect_refused_with_a_cure(
        {"numerics.density_scale=10000", "numerics.node_spacing=0.35", "numerics.dt=\"9.9 us\""});
}

TEST_F(Trial, refuses_cells_so_dense_that_they_burst_apart) {
    expect_refused_with_a_cure({"cells.radius=\"4.8 um\"", "cells.count=auto",
                                "cells.hematocrit=90 %", "cells.layout=random",
                                "flow.pseudo_shear_rate=\"1 /s\""});
}

TEST_F(Trial, of_cells_that_no_numerics_keep_advises_fewer) {
    const std::vector<std::string> changes{"cells.radius=\"4.8 um\"", "cells.hematocrit=90 %",
                                           "cells.count=auto", "cells.layout=random"};
    const Case c = read_case(path("case.toml").string(), changes);
    const Model model = discretise(c);
    Instability hopeless;
    hopeless.quantity = "area error";
    State broken = initial_state(c, model);
    broken.cells.x[0] += 8.0;  // no step and no coupling mends that
    const Advice advice = refusal_after(hopeless, c, model, broken);
    EXPECT_NE(advice.text.find("Write hematocrit = \"60 %\""), std::string::npos) << advice.text;
}

TEST_F(Trial, that_is_stopped_leaves_nothing) {
    const Case c = read_case(path("case.toml").string());
    const Model model = discretise(c);
    const State initial = initial_state(c, model);
    request_stop();
    EXPECT_THROW(instability_within(10, model, initial), StoppedEarly);
    clear_stop_request();
    EXPECT_FALSE(instability_within(10, model, initial));
}

TEST(IsUnusual, no_case_that_comes_with_the_program) {
    for (const auto& folder : fs::directory_iterator(TT_SOURCE_DIR "/cases")) {
        const fs::path file = folder.path() / "case.toml";
        if (!fs::exists(file)) continue;
        const Case c = read_case(file.string());
        if (!c.geometry.straight()) continue;  // the flow of plasma takes long to find
        const Choice choice = choose(c);
        const Model model = discretise(c, choice);
        const Appraisal a = appraise(c, choice, model, initial_state(c, model));
        EXPECT_FALSE(is_unusual(c, choice, a)) << file;
    }
}

TEST(IsUnusual, a_number_by_hand_far_from_what_auto_takes) {
    const auto unusual = [](const std::string& change) {
        const Case c = read_case(TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml", {change});
        return is_unusual(c, choose(c), Appraisal{});
    };
    for (const char* change : {"numerics.density_scale=1000", "numerics.node_spacing=0.4",
                               "numerics.relaxation_time=0.52", "numerics.relaxation_time=6",
                               "numerics.step_tolerance=10 %", "numerics.dt=\"20 us\""})
        EXPECT_TRUE(unusual(change)) << change;
    for (const char* change : {"numerics.density_scale=2", "numerics.node_spacing=1",
                               "numerics.relaxation_time=1", "numerics.dt=\"0.1 us\""})
        EXPECT_FALSE(unusual(change)) << change;
}

}  // namespace
}  // namespace tt
