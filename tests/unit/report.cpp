#include "report/report.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "report/export.hpp"
#include "observe/status.hpp"
#include "report/words.hpp"
#include "small_run.hpp"
#include "unit/invented_results.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

bool asks_the_network(const std::string& page) {
    static const std::regex link("(src|href|url|action)\\s*[=(]\\s*[\"']?\\s*(https?:)?//",
                                 std::regex::icase);
    return std::regex_search(page, link) || page.find("fetch(") != std::string::npos ||
           page.find("XMLHttpRequest") != std::string::npos ||
           page.find("<link") != std::string::npos;
}

TEST(Report, page_of_one_run_is_whole_and_needs_no_network) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    const std::array<fs::path, 1> runs{scratch / "run"};
    const fs::path path = write_report(runs);
    EXPECT_EQ(path, scratch / "run" / "report.html");
    const std::string page = text_of(path);
    EXPECT_FALSE(asks_the_network(page));
    for (const char* part : {"<h1>channel-500-LD</h1>", "id=\"picture\"", "uPlot=function",
                             "resolved.toml", "data:image/svg+xml;base64,", "40 to 80 ms",
                             "pseudo-shear rate (mean velocity / width) of 500 /s"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("not finished"), std::string::npos);
    EXPECT_LT(page.size(), 1'500'000u);
    EXPECT_TRUE(asks_the_network("<img src=\"https://x\">")) << "the check itself can fail";
}

TEST(Report, comparison_has_runs_side_by_side_and_raises_overlaps) {
    ScratchFolder scratch;
    invent_results(scratch / "good");
    invent_results(scratch / "bad", "--overlaps 3");
    const std::array<fs::path, 2> runs{scratch / "good", scratch / "bad"};
    const std::string page = text_of(write_report(runs, scratch / "comparison"));
    EXPECT_NE(page.find("Comparison of channel-500-LD (good), channel-500-LD (bad)"),
              std::string::npos);
    EXPECT_NE(page.find("contact forces did not keep the cells apart"), std::string::npos);
    EXPECT_TRUE(fs::exists(scratch / "comparison" / "figures" / "lambda_C.svg"));
    EXPECT_FALSE(fs::exists(scratch / "good" / "report.html"));
}

TEST(Report, damaged_frames_and_tables_are_left_out_and_told_on_the_page) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 3");
    const fs::path frames = scratch / "run" / "frames.h5", cells = scratch / "run" / "cells.csv";
    std::string bytes = text_of(frames);
    bytes[bytes.size() * 3 / 5] ^= 1;
    std::ofstream(frames, std::ios::binary) << bytes;
    std::string table = text_of(cells);
    table[table.size() / 2] = 'x';
    std::ofstream(cells, std::ios::binary) << table;
    const std::array<fs::path, 1> runs{scratch / "run"};
    const std::string page = text_of(write_report(runs));
    EXPECT_NE(page.find("frames.h5 is damaged: frame 1 left out"), std::string::npos);
    EXPECT_NE(page.find("cells.csv is damaged: "), std::string::npos);
    export_csv(scratch / "run", scratch / "csv");
    EXPECT_TRUE(fs::exists(scratch / "csv" / "nodes_000002.csv"));
    EXPECT_FALSE(fs::exists(scratch / "csv" / "nodes_000001.csv"));
}

/// Whatever became of them: no one file costs the page the rest.
TEST(Report, damaged_records_and_tables_that_are_gone_are_told_on_the_page) {
    ScratchFolder scratch;
    const fs::path run = scratch / "run";
    run_small(small_request(run, 200));
    const std::array<fs::path, 1> runs{run};
    fs::remove(run / "cells.csv");
    for (const char* text : {"[[[", "[]",
                             "{\"sessions\": [{\"changes\": {\"a\": 1}}, 5], "
                             "\"status\": 3, \"step\": \"x\", \"checks\": 7}"}) {
        for (const char* name : {"summary.json", "status.json", "PROVENANCE.json"})
            std::ofstream(run / name) << text;
        const std::string page = text_of(write_report(runs));
        EXPECT_NE(page.find("cells.csv is gone"), std::string::npos) << text;
        EXPECT_EQ(page.find("status.json is damaged") != std::string::npos, text[0] == '[');
        EXPECT_EQ(page.find("summary.json is damaged") != std::string::npos, text[0] == '[');
    }
    EXPECT_NE(describe_status(read_status(run)).find("?: unknown"), std::string::npos);
}

TEST(Report, unfinished_runs_say_how_far_they_came) {
    ScratchFolder scratch;
    invent_results(scratch / "running", "--stage running");
    invent_results(scratch / "started", "--stage started");
    for (const char* name : {"running", "started"}) {
        const std::array<fs::path, 1> runs{scratch / name};
        EXPECT_NE(text_of(write_report(runs)).find("had reached 48 of 80 ms"), std::string::npos)
            << name;
    }
}

TEST(Report, directory_that_a_run_wrote_is_understood) {
    ScratchFolder scratch;
    run_small(small_request(scratch / "run", 200));
    const Results run = read_results(scratch / "run");
    EXPECT_EQ(run.name, "small");
    EXPECT_TRUE(run.finished());
    EXPECT_EQ(unfinished_note(run), "");
    EXPECT_GT(run.window_end, run.window_begin);
    ASSERT_TRUE(run.frames);
    EXPECT_EQ(run.frames->count(), 9);

    const std::array<fs::path, 1> runs{scratch / "run"};
    const std::string page = text_of(write_report(runs));
    EXPECT_NE(page.find("cfl_profile"), std::string::npos);
    EXPECT_GE(run.checks.size(), 7u);
    for (const RunCheck& check : run.checks)
        EXPECT_NE(page.find(check.sentence), std::string::npos) << check.name;
    for (const char* figure :
         {"flow", "lambda_C", "mu_rel", "velocity_profile", "hematocrit_profile"})
        EXPECT_TRUE(fs::exists(scratch / "run" / "figures" / (std::string(figure) + ".svg")))
            << figure;
    export_vtk(scratch / "run", scratch / "vtk");
    EXPECT_TRUE(fs::exists(scratch / "vtk" / "cells" / "cells_000008.vtp"));
}

/// What a name could do to a page, to gnuplot and to a shell.
constexpr const char* hostile = "</script><b>&'\"`touch made`$(touch made){/:Bold x}\n@a;-";

/// Results of runs with that name, in a folder of that name.
fs::path invent_hostile(const ScratchFolder& scratch) {
    invent_results(scratch / "run", "--frames 2");
    for (const char* name : {"case.toml", "resolved.toml"}) {
        std::string text = text_of(scratch / "run" / name);
        const std::string plain = "name = \"channel-500-LD\"";
        text.replace(text.find(plain), plain.size(),
                     std::string("name = '''") + hostile + "\nsecond line'''");
        std::ofstream(scratch / "run" / name) << text;
    }
    std::string folder = hostile;
    for (char& c : folder)
        if (c == '/') c = '|';
    fs::rename(scratch / "run", scratch / folder);
    return scratch / folder;
}

std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
    return count;
}

TEST(Report, a_hostile_name_is_shown_and_never_run) {
    ScratchFolder scratch;
    const fs::path run = invent_hostile(scratch);
    ASSERT_NE(read_results(run).name.find("</script>"), std::string::npos);
    const std::array<fs::path, 1> one{run};
    const std::string page = text_of(write_report(one));
    EXPECT_EQ(count_of(page, "</script>"), 3u) << "those of the page itself";
    EXPECT_EQ(page.find("<b>&"), std::string::npos);
    EXPECT_NE(page.find("&lt;/script&gt;&lt;b&gt;&amp;&#39;&quot;"), std::string::npos);

    const std::array<fs::path, 2> two{run, run};
    const std::string both = text_of(write_report(two, scratch / "both"));
    EXPECT_EQ(count_of(both, "</script>"), 3u);
    EXPECT_TRUE(fs::exists(scratch / "both" / "figures" / "lambda_C.svg"));
    for (const auto& entry : fs::recursive_directory_iterator(scratch / ""))
        EXPECT_NE(entry.path().filename(), "made") << entry.path();
    EXPECT_FALSE(fs::exists("made"));
}

TEST(Report, how_to_repeat_gives_each_run_a_folder_of_its_own_in_words_a_shell_takes) {
    ScratchFolder scratch;
    invent_results(scratch / "a", "--frames 2");
    fs::copy(scratch / "a", scratch / "it's b", fs::copy_options::recursive);
    const std::array<fs::path, 2> runs{scratch / "a", scratch / "it's b"};
    const std::string page = text_of(write_report(runs, scratch / "both"));
    const std::string folder = (scratch / "").string();
    EXPECT_NE(page.find("tanktread run " + folder + "a/resolved.toml -o " + folder + "a-again\n"),
              std::string::npos);
    const std::string quoted = "&#39;" + folder + "it&#39;\\&#39;&#39;s b";
    EXPECT_NE(page.find("run " + quoted + "/resolved.toml&#39; -o " + quoted + "-again&#39;\n"),
              std::string::npos);
}

TEST(Report, twenty_runs_are_told_apart_by_what_differs) {
    ScratchFolder scratch;
    invent_results(scratch / "run0", "--frames 2");
    std::vector<fs::path> runs{scratch / "run0"};
    for (int k = 1; k < 20; ++k) {
        runs.push_back(scratch / ("run" + std::to_string(k)));
        fs::copy(runs[0], runs.back(), fs::copy_options::recursive);
        std::string text = text_of(runs[0] / "resolved.toml");
        text.replace(text.find("500 /s"), 6, std::to_string(500 + k) + " /s");
        std::ofstream(runs.back() / "resolved.toml") << text;
    }
    const std::string page = text_of(write_report(runs, scratch / "all"));
    EXPECT_NE(page.find("<h1>Comparison of 20 runs</h1>"), std::string::npos);
    EXPECT_NE(page.find("Settings that differ."), std::string::npos);
    EXPECT_NE(page.find(">flow.pseudo_shear_rate<"), std::string::npos);
    EXPECT_EQ(page.find(">domain.width<"), std::string::npos) << "the same in all";
    EXPECT_EQ(count_of(page, "drives the flow along the channel"), 1u);
    const std::string script = text_of(scratch / "all" / "figures" / "mu_rel.gp");
    EXPECT_NE(script.find("set key outside bottom"), std::string::npos);
    EXPECT_NE(script.find("linetype 20 "), std::string::npos);
    EXPECT_NE(text_of(scratch / "all" / "figures" / "style.gp").find("set linetype 20 "),
              std::string::npos)
        << "and it has a look of its own";
}

TEST(Words, numbers_are_written_as_people_write_them) {
    EXPECT_EQ(number_text(539800.0), "5.398 × 10⁵");
    EXPECT_EQ(number_text(-1.5e-7, 2), "−1.5 × 10⁻⁷");
    EXPECT_EQ(number_text(std::nan("")), "–");
    EXPECT_EQ(with_scatter(1.11428, 0.00742), "1.1143 ± 0.0074");
    EXPECT_EQ(with_scatter(3.997e-4, 8.6e-5), "(4.00 ± 0.86) × 10⁻⁴");
    EXPECT_EQ(with_scatter(-13.01, 2.5), "−13.0 ± 2.5");
    EXPECT_EQ(with_scatter(0.377, 5e-17), "0.377");
    EXPECT_EQ(with_scatter(0.227721, 4e-10), "0.2277");
}

}  // namespace
}  // namespace tt
