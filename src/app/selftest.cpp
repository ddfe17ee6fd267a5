#include "app/selftest.hpp"
#include "base/tell.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

#include "app/verb.hpp"
#include "io/json.hpp"

namespace tt {
namespace {

std::vector<Check> outcome_of(const SelftestPart& part) {
    try {
        return part.run();
    } catch (const std::exception& error) {
        return {{fmt::format("{}: {}", part.name, error.what()), 0.0, std::nan(""), 0.0}};
    }
}

void print_row(const Check& c) {
    fmt::print("{:<35} {:>9.5g} {:>9.5g} {:>8.1e} {:>7.1e}  {}\n", c.what, c.expected, c.got,
               c.error(), c.tolerance, c.passed() ? "ok" : "FAILED");
    std::fflush(stdout);
}

}  // namespace

int run_selftest(std::span<const SelftestPart> parts, bool json) {
    const auto begin = std::chrono::steady_clock::now();
    int failed = 0, count = 0;
    Json list = Json::array();
    if (!json)
        fmt::print("{:<35} {:>9} {:>9} {:>8} {:>7}\n", "what", "expected", "got", "error",
                   "allowed");
    for (const SelftestPart& part : parts) {
        for (const Check& c : outcome_of(part)) {
            ++count;
            failed += c.passed() ? 0 : 1;
            if (json) {
                list.push_back({{"part", part.name},
                                {"what", c.what},
                                {"expected", c.expected},
                                {"got", c.got},
                                {"error", c.error()},
                                {"tolerance", c.tolerance},
                                {"passed", c.passed()}});
            } else {
                print_row(c);
            }
        }
    }
    if (json) fmt::print("{}\n", list.dump(2));
    std::fflush(stdout);  // before what goes to stderr
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (failed > 0)
        tell_user("tanktread: {} of {} checks failed: do not trust this build\n", failed, count);
    else
        tell_user("{} checks passed in {:.0f} s\n", count, seconds);
    return failed > 0 ? exit_code::internal : exit_code::done;
}

void add_selftest(CLI::App& app, Action& action) {
    auto json = std::make_shared<bool>(false);
    CLI::App* verb =
        app.add_subcommand("selftest", "hold the physics of this very build to exact answers");
    verb->add_flag("--json", *json, "as JSON");
    verb->footer(
        "Some ten seconds. Each line is a number of a small scene: what it must be by\n"
        "theory or by an independent solution, what this build makes of it, the error,\n"
        "relative where a number is expected, and the error allowed at this resolution.\n"
        "Exit code 1 if any failed.");
    verb->callback(
        [json, &action] { action = [json] { return run_selftest(selftest_parts(), *json); }; });
}

}  // namespace tt
