#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "command.hpp"
#include "io/json.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// A run that blows up, by the program: a cell almost without viscosity, whose area is kept by a
/// pressure just below what `check` refuses.
class FailedRun : public TemporaryDirectory {
protected:
    FailedRun() {
        replace_file(path("case.toml"), R"(format = 1
[domain]
length = "20 um"
width = "12 um"
[flow]
drive = "pressure"
pseudo_shear_rate = "80 /s"
[cells]
count = 1
radius = "2.7 um"
cytoplasm_viscosity = "0.0745 cP"
[membrane]
hold_area = false
area_stiffness = "9.51 kPa"
[numerics]
dx = "0.5 um"
jump_correction = true
[time]
end = "1 ms"
[output]
series = "0.2 ms"
frames = "0.2 ms"
)",
                     Durability::process);
    }
    Outcome run_verb(const std::string& verb, std::vector<std::string> more = {}) const {
        std::vector<std::string> words{
            verb, path("case.toml").string(), "-o", results(), "-j", "1", "--progress", "none"};
        if (verb == "resume") words = {verb, results(), "-j", "1", "--progress", "none"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    std::string results() const { return path("o").string(); }
    std::string failure(const std::string& name) const {
        return (path("o") / "failure" / name).string();
    }
};

/// A path may be longer than a line.
std::string longest_line_without_path(const std::string& text) {
    std::istringstream lines(text);
    std::string longest;
    for (std::string line; std::getline(lines, line);)
        if (line.find('/') == std::string::npos && line.size() > longest.size()) longest = line;
    return longest;
}

TEST_F(FailedRun, ends_with_3_and_tells_once_what_where_and_what_to_write) {
    const Outcome outcome = run_verb("run");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out, "");
    const std::size_t at = outcome.err.find("unstable at step");
    ASSERT_NE(at, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("unstable at step", at + 1), std::string::npos) << outcome.err;
    for (const char* word : {"cell 0, node ", "at x = ", "cause:", "write: --set membrane."})
        EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(results() + "/failure"), std::string::npos) << outcome.err;
    EXPECT_LE(longest_line_without_path(outcome.err).size(), 80u);
    for (const char* name : {"why.txt", "failure.json", "last_good", "failing", "frames.h5"})
        EXPECT_TRUE(fs::exists(failure(name))) << name;
    EXPECT_EQ(read_json(path("o") / "status.json")["status"], "failed");
}

TEST_F(FailedRun, is_not_repeated_by_run_and_resume) {
    run_verb("run");
    const std::string why = read_file(failure("why.txt"));
    const std::string series = read_file(path("o") / "series.csv");
    for (const char* verb : {"run", "resume"}) {
        const Outcome again = run_verb(verb);
        EXPECT_EQ(again.code, 3);
        EXPECT_NE(again.err.find("failed before, and the same would happen again"),
                  std::string::npos)
            << again.err;
        EXPECT_NE(again.err.find(why), std::string::npos) << again.err;
        EXPECT_EQ(read_file(path("o") / "series.csv"), series);
    }
    EXPECT_EQ(run_verb("run", {"--fresh"}).code, 3) << "begins anew";
    EXPECT_TRUE(fs::exists(path("o.1") / "failure/why.txt"));
}

/// The advice is `--set key=value …`, as one would write it after the command.
std::vector<std::string> settings_in(const std::string& advice) {
    std::vector<std::string> words;
    for (std::size_t at = 0; (at = advice.find("--set ", at)) != std::string::npos;) {
        at += 6;
        std::string value;
        for (bool quoted = false; at < advice.size() && (quoted || advice[at] != ' '); ++at) {
            if (advice[at] == '"') quoted = !quoted;
            value += advice[at];
        }
        words.insert(words.end(), {"--set", value});
    }
    return words;
}

/// Cases of its kind, of which some blow up. More of them on demand: TANKTREAD_FAILURES=50.
std::vector<std::string> random_settings(Random& random) {
    std::vector<std::string> words;
    const auto set = [&](const char* format, double low, double high) {
        const double value = std::pow(10.0, random.uniform(low, high));
        words.insert(words.end(), {"--set", fmt::format(fmt::runtime(format), value)});
    };
    set("cells.cytoplasm_viscosity={:.3g} cP", -1.2, -1.0);
    set("flow.pseudo_shear_rate={:.3g} /s", 1.2, 2.0);
    set("membrane.area_stiffness={:.3g} kPa", 0.8, 1.0);
    return words;
}

TEST_F(FailedRun, runs_to_its_end_with_what_it_advises) {
    const char* const asked = std::getenv("TANKTREAD_FAILURES");
    const int wanted = asked ? std::atoi(asked) : 2;
    Random random(2014);
    for (int failures = 0; failures < wanted;) {
        std::vector<std::string> words = random_settings(random);
        words.push_back("--fresh");
        if (run_verb("run", words).code != 3) continue;
        ++failures;
        const std::string advice = read_json(failure("failure.json"))["advice"];
        const std::vector<std::string> advised = settings_in(advice);
        EXPECT_FALSE(advised.empty()) << fmt::format("{}: {}", fmt::join(words, " "), advice);
        words.insert(words.end(), advised.begin(), advised.end());
        EXPECT_EQ(run_verb("run", words).code, 0) << fmt::format("{}", fmt::join(words, " "));
    }
}

}  // namespace
}  // namespace tt
