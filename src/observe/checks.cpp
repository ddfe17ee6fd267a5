#include "observe/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "base/words.hpp"
#include "observe/failure.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
using Verdict = RunCheck::Verdict;
constexpr std::array<const char*, 3> verdict_names{"ok", "warning", "failed"};

}  // namespace

std::vector<RunCheck> checks_from(const Json& list) {
    std::vector<RunCheck> checks;
    if (!list.is_array()) return checks;
    for (const Json& json : list) {
        if (!json.is_object()) continue;
        const auto text = [&](const char* key) { return text_of(json, key); };
        const auto verdict = std::find(verdict_names.begin(), verdict_names.end(), text("verdict"));
        if (verdict == verdict_names.end()) continue;
        checks.push_back({text("name"), static_cast<Verdict>(verdict - verdict_names.begin()),
                          number_of(json, "value", undefined), number_of(json, "limit", undefined),
                          text("unit"), text("sentence")});
    }
    return checks;
}

std::vector<RunCheck> read_checks(const fs::path& results) {
    const Json summary = read_object(results / "summary.json");
    if (const auto found = summary.find("checks"); found != summary.end())
        return checks_from(*found);
    if (!fs::exists(results / "series.csv")) return {};
    const Table series = read_csv(results / "series.csv");
    CheckInput input;
    input.finished = false;
    const double dx = number_of(read_object(results / "status.json"), "dx", undefined);
    if (std::isfinite(dx)) input.dx = Length{dx};
    if (series.rows() == 0) return {};
    std::vector<RunCheck> checks = judge(series, input);
    if (has_failed(results))
        checks.insert(checks.begin(), {"stability", Verdict::failed, undefined, undefined, "",
                                       "The run blew up; failure/why.txt says why."});
    return checks;
}

Json to_json(const std::vector<RunCheck>& checks) {
    Json list = Json::array();
    for (const RunCheck& c : checks)
        list.push_back({{"name", c.name},
                        {"verdict", verdict_names[static_cast<std::size_t>(c.verdict)]},
                        {"value", std::isfinite(c.value) ? Json(c.value) : Json(nullptr)},
                        {"limit", c.limit},
                        {"unit", c.unit},
                        {"sentence", c.sentence}});
    return list;
}

std::string describe_checks(const std::vector<RunCheck>& checks) {
    std::string text;
    for (const RunCheck& c : checks)
        if (c.verdict != Verdict::ok)
            text +=
                wrapped(fmt::format("{}: {}", c.verdict == Verdict::failed ? "FAILED" : "warning",
                                    c.sentence),
                        79, 2) +
                "\n";
    if (text.empty() && !checks.empty())
        text = fmt::format("checks: all {} in order\n", checks.size());
    return text;
}

}  // namespace tt
