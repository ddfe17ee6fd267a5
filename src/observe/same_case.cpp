#include "observe/same_case.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {
namespace {

using Settings = std::map<std::string_view, std::string_view>;

Settings parsed(std::string_view lines) {
    constexpr std::string_view is = " = ";
    Settings settings;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
        const std::size_t at = line.find(is);
        if (at != std::string_view::npos)
            settings[line.substr(0, at)] = line.substr(at + is.size());
    }
    return settings;
}

bool begins(std::string_view key, std::string_view with) { return key.starts_with(with); }

bool may_differ(std::string_view key) {
    return key == "name" || begins(key, "time.") || begins(key, "output.");
}

std::string_view value_of(const Settings& settings, std::string_view key) {
    const auto found = settings.find(key);
    return found == settings.end() ? "not known" : found->second;
}

/// A line per key that differs and may not. What the program chose follows from the rest, and is of
/// interest only where nothing else differs.
std::string differences(const Settings& theirs, const Settings& ours) {
    Settings keys = theirs;
    keys.insert(ours.begin(), ours.end());
    std::string given, chosen;
    for (const auto& [key, value] : keys) {
        const std::string_view there = value_of(theirs, key), here = value_of(ours, key);
        if (there == here || may_differ(key)) continue;
        (begins(key, "chosen.") ? chosen : given) +=
            fmt::format("  {}: {} there, {} here\n", key, there, here);
    }
    return given.empty() ? chosen : given;
}

}  // namespace

void expect_same_case(const std::filesystem::path& directory, const std::string& theirs,
                      const std::string& ours) {
    if (theirs == ours) return;
    const std::string list = differences(parsed(theirs), parsed(ours));
    if (list.empty()) return;
    throw DirectoryInUse(fmt::format(
        "'{}' holds results of another case:\n{}A run goes on with another name, time or output "
        "only; choose another directory with -o, or move the former results aside with --fresh",
        directory.string(), list));
}

}  // namespace tt
