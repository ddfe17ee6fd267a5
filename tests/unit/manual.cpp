#include "command.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/file.hpp"
#include "temporary_directory.hpp"

namespace {

using tt::run;
using Words = std::set<std::string>;

/// What pattern's group finds in the text, all of it.
Words all_of(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    Words words;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
        words.insert((*at)[1]);
    return words;
}

Words verbs() {
    const std::string help = run({"--help"}).out;
    const std::size_t begin = help.find("\nVerbs:");
    return all_of(help.substr(begin, help.find("\n\n", begin + 1) - begin), "\n  ([a-z]+) ");
}

Words long_options(const std::string& verb) {
    return all_of(run({verb, "--help"}).out, "\n  (?:-[a-z],)?(--[a-z-]+) ");
}

/// The words that the shells offer in place of the last one.
Words offered(std::vector<std::string> words) {
    words.insert(words.begin(), {"complete", "--"});
    return all_of(run(words).out, "\n([^\t\n]+)\t");
}

std::string kind_offered(std::vector<std::string> words) {
    words.insert(words.begin(), {"complete", "--"});
    const std::string out = run(words).out;
    return out.substr(0, out.find('\n'));
}

class Manual : public tt::TemporaryDirectory {};

TEST_F(Manual, has_a_page_of_each_verb_with_all_its_options) {
    ASSERT_EQ(run({"manual", path("man").string()}).code, 0);
    EXPECT_GE(verbs().size(), 10u);
    for (const std::string& verb : verbs()) {
        std::string page = tt::read_file(path("man") / ("tanktread-" + verb + ".1"));
        page = std::regex_replace(page, std::regex("\\\\-"), "-");
        EXPECT_FALSE(long_options(verb).empty()) << verb;
        for (const std::string& option : long_options(verb))
            EXPECT_NE(page.find("\\fB" + option + "\\fR"), std::string::npos) << verb << option;
    }
    const std::string keys = tt::read_file(path("man") / "tanktread-case.5");
    EXPECT_NE(keys.find(".SH [membrane.hardening]\n"), std::string::npos);
    EXPECT_NE(keys.find("pseudo_shear_rate = \"500 /s\""), std::string::npos);
}

TEST(Completion, offers_the_verbs_and_options_of_the_help) {
    Words all = verbs();
    all.insert("help");
    EXPECT_EQ(offered({""}), all);
    EXPECT_EQ(offered({"he"}), Words{"help"});
    for (const std::string& verb : verbs()) EXPECT_EQ(offered({verb, "--"}), long_options(verb));
    EXPECT_EQ(offered({"help", "re"}), (Words{"report", "resume"}));
    EXPECT_EQ(offered({"no-verb", ""}), Words{});
}

TEST(Completion, offers_what_the_value_may_be) {
    EXPECT_EQ(offered({"run", "a.toml", "--progress", ""}),
              (Words{"auto", "bar", "log", "json", "none"}));
    EXPECT_EQ(offered({"run", "--progress=n"}), Words{"--progress=none"});
    EXPECT_EQ(offered({"export", "d", "--to", ""}), (Words{"vtk", "csv", "png"}));
    EXPECT_EQ(offered({"new", "a", "--from", "po"}), (Words{"poiseuille", "posts"}));
    EXPECT_EQ(kind_offered({"run", ""}), "files");
    EXPECT_EQ(kind_offered({"run", "--fresh", "-j", "2", ""}), "files");
    EXPECT_EQ(kind_offered({"run", "a.toml", "-o", ""}), "directories");
    EXPECT_EQ(kind_offered({"report", "a", "b", ""}), "directories");
    EXPECT_EQ(offered({"run", "a.toml", ""}), Words{});  // one file only
    EXPECT_EQ(offered({"run", "a.toml", "-j", ""}), Words{});
}

TEST(Completion, offers_keys_and_their_words) {
    EXPECT_EQ(offered({"check", "a.toml", "--set", "flow.dr"}), Words{"flow.drive="});
    EXPECT_EQ(offered({"check", "a.toml", "--set", "flow.drive="}),
              (Words{"flow.drive=none", "flow.drive=pressure", "flow.drive=body-force",
                     "flow.drive=shear"}));
    EXPECT_EQ(offered({"resume", "d", "--set", "numerics.fluid_only=t"}),
              Words{"numerics.fluid_only=true"});
    EXPECT_EQ(offered({"run", "--set", "membrane.hardening.apply_to=shear,b"}),
              Words{"membrane.hardening.apply_to=shear,bending"});
    EXPECT_EQ(offered({"keys", "time"}), (Words{"time", "time.end", "time.average_from"}));
    EXPECT_EQ(offered({"run", "--set", "no.key="}), Words{});
}

TEST(Completion, a_word_that_is_not_among_those_of_an_option_is_told_with_the_nearest) {
    const tt::Outcome outcome = run({"run", "a.toml", "--progress", "jsn"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("--progress: jsn is not one of auto, bar, log, json, none; did you "
                               "mean 'json'?"),
              std::string::npos)
        << outcome.err;
}

}  // namespace
