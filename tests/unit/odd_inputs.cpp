#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/words.hpp"
#include "case/run_name.hpp"
#include "command.hpp"
#include "io/file.hpp"
#include "source_dir.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

TEST(Words, longer_than_a_name_lose_their_middle) {
    const std::string plain = "cannot open 'a b': it is not there";
    EXPECT_EQ(with_short_words(plain), plain);
    EXPECT_EQ(with_short_words(std::string(255, 'x')), std::string(255, 'x'));
    EXPECT_EQ(with_short_words("at '" + std::string(5000, 'x') + "' is\nno file"),
              "at '" + std::string(59, 'x') + " ... " + std::string(59, 'x') + "' is\nno file");
    std::string letters;  // of two bytes each: none is cut
    for (int n = 0; n < 300; ++n) letters += "µ";
    const std::string cut = with_short_words("x" + letters);
    EXPECT_EQ(cut.find("x"), 0u);
    EXPECT_EQ(cut.size() % 2, 0u) << cut;
}

TEST(Words, quotes_are_open_or_closed) {
    EXPECT_FALSE(has_open_quote("1,2"));
    EXPECT_FALSE(has_open_quote("\"x\",\"y\""));
    EXPECT_TRUE(has_open_quote("1,\"2"));
}

class OddInputs : public TemporaryDirectory {};

TEST_F(OddInputs, an_over_long_path_does_not_fill_the_screen) {
    const std::string path(5000, 'p');
    const std::string channel = TT_SOURCE_DIR "/cases/05-channel/case.toml";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"check", path},
             {"check", "/" + path + "/case.toml"},
             {path},
             {"run", channel, "-o", path},
             {"status", path},
             {"report", path},
             {"export", path, "--to", "csv"},
             {"resume", path},
             {"sweep", path},
             {"check", channel, "--set", "cells.shape=file", "--set", "cells.file=" + path}}) {
        const Outcome outcome = run(words);
        EXPECT_NE(outcome.code, 0);
        EXPECT_NE(outcome.code, 1) << outcome.err;
        EXPECT_LT(outcome.err.size(), 1000u) << words[0];
    }
}

TEST_F(OddInputs, frames_without_a_flow_are_exported_without_a_folder_for_it) {
    const std::string results = path("r").string(), vtk = path("vtk").string();
    ASSERT_EQ(run({"run", TT_SOURCE_DIR "/cases/03-cell-in-shear/case.toml", "-o", results, "-j",
                   "1", "--progress", "none", "--set", "time.end=\"0.1 ms\"", "--set",
                   "time.average_from=\"0.05 ms\"", "--set", "output.fields=never"})
                  .code,
              0);
    const Outcome outcome = run({"export", results, "--to", "vtk", "-o", vtk});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("no frame holds the flow"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("vtk") / "flow"));
    EXPECT_FALSE(fs::exists(path("vtk") / "flow.pvd"));
    EXPECT_TRUE(fs::exists(path("vtk") / "cells.pvd"));
    EXPECT_TRUE(fs::exists(path("vtk") / "cells" / "cells_000000.vtp"));
}

TEST_F(OddInputs, a_cell_that_starts_in_a_post_may_start_elsewhere) {
    const Outcome outcome =
        run({"check", TT_SOURCE_DIR "/cases/08-posts/case.toml", "--set", "cells.layout=single",
             "--set", "cells.count=1", "--set", "cells.radius=\"9 um\""});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("layout = \"random\""), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace tt
