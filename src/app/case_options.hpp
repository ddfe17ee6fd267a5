#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/quantity.hpp"
#include "case/case.hpp"
#include "case/choose.hpp"

namespace CLI {
class App;
}

namespace tt {

/// What check and run share.
struct CaseOptions {
    std::string path;
    std::vector<std::string> overrides;
    int threads = 0;  ///< 0: as many as are of use
};

/// Adds the case file, --set and -j.
void add_case_options(CLI::App& verb, CaseOptions& options);

/// A case and the text of its file. A pipe can be read once only.
struct GivenCase {
    std::string text;
    Case c;
};

/// Reads the case. Throws CaseError; IoError, with the file that was probably meant, if there is
/// none.
GivenCase read_given_case(const CaseOptions& options);

/// Throws CaseError if the sites of the grid are more than fit into the memory that this process
/// may use.
void expect_memory(const Case& c, const Choice& choice);

/// Adds --set alone.
void add_set_option(CLI::App& verb, CaseOptions& options);

/// Adds -j alone.
void add_threads_option(CLI::App& verb, int& threads);

/// How many threads share a step, and why.
struct ThreadChoice {
    int threads = 1;
    std::string reason;
};

/// About as many membrane nodes as the case will have, before its cells are placed: their perimeter
/// is taken for a circle's.
std::int64_t expected_nodes(const Case& c, const Choice& choice);

/// `asked`; 0: of the usable processors as many as the case gives work to, judged before its cells
/// are placed.
ThreadChoice choose_threads(int asked, const Case& c, const Choice& choice);

/// "55m", "90s", "1h30m", "2 h", "5 min": a time on the clock on the wall, where m is a minute.
/// Throws CommandError naming `option`.
Time parse_duration(std::string_view option, std::string_view text);

/// A quantity of simulated time, "50 ms". Throws CommandError naming `option`.
Time parse_time(std::string_view option, std::string_view text);

}  // namespace tt
