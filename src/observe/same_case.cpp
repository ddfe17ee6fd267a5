#include "observe/same_case.hpp"

#include <algorithm>
#include <array>
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

bool may_differ(std::string_view key) {
    return key == "name" || key.starts_with("time.") || key.starts_with("output.");
}

/// Keys that change how a case is computed, not what it asks for, and that leave a state with which
/// to go on. What the program chose by them goes with them.
bool is_numerics(std::string_view key) {
    static constexpr std::array<std::string_view, 20> keys{"numerics.dt",
                                                           "numerics.density_scale",
                                                           "numerics.relaxation_time",
                                                           "numerics.step_tolerance",
                                                           "numerics.jump_correction",
                                                           "numerics.implicit_tension",
                                                           "numerics.delta",
                                                           "numerics.collision",
                                                           "numerics.magic",
                                                           "numerics.equilibrium",
                                                           "numerics.precision",
                                                           "numerics.interior",
                                                           "numerics.interface_viscosity",
                                                           "numerics.viscosity_mean",
                                                           "numerics.smoothing_width",
                                                           "membrane.area_stiffness",
                                                           "membrane.hold_area",
                                                           "contact.range",
                                                           "contact.short_range_repulsion",
                                                           "contact.repulsion_strength"};
    if (key.starts_with("chosen."))
        return key != "chosen.dx" && key != "chosen.relaxation_time" &&
               key != "chosen.node_spacing";
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string_view value_of(const Settings& settings, std::string_view key) {
    const auto found = settings.find(key);
    return found == settings.end() ? "not known" : found->second;
}

/// Those that differ. What the program chose follows from the rest, and is of interest only where
/// nothing else differs.
std::vector<SettingChange> differences(const Settings& theirs, const Settings& ours,
                                       bool (*wanted)(std::string_view key)) {
    Settings keys = theirs;
    keys.insert(ours.begin(), ours.end());
    std::vector<SettingChange> given, chosen;
    for (const auto& [key, value] : keys) {
        const std::string_view there = value_of(theirs, key), here = value_of(ours, key);
        if (there == here || !wanted(key)) continue;
        (key.starts_with("chosen.") ? chosen : given)
            .push_back({std::string(key), std::string(there), std::string(here)});
    }
    return given.empty() ? chosen : given;
}

/// DirectoryInUse with what differs and may not; `may` says in words what may.
void refuse(const std::filesystem::path& directory, const std::vector<SettingChange>& changes,
            const char* may) {
    if (changes.empty()) return;
    std::string list;
    for (const SettingChange& change : changes)
        list += fmt::format("  {}: {} there, {} here\n", change.key, change.before, change.after);
    throw DirectoryInUse(fmt::format(
        "'{}' holds results of another case:\n{}{}; choose another directory with -o, or move the "
        "former results aside with --fresh",
        directory.string(), list, may));
}

}  // namespace

void expect_same_case(const std::filesystem::path& directory, const std::string& theirs,
                      const std::string& ours) {
    if (theirs == ours) return;
    const auto fixed = [](std::string_view key) { return !may_differ(key); };
    refuse(directory, differences(parsed(theirs), parsed(ours), fixed),
           "A run goes on with another name, time or output only");
}

std::vector<SettingChange> changed_numerics(const std::filesystem::path& directory,
                                            const std::string& theirs, const std::string& ours) {
    const auto fixed = [](std::string_view key) { return !may_differ(key) && !is_numerics(key); };
    refuse(directory, differences(parsed(theirs), parsed(ours), fixed),
           "After a blow-up a run goes on with another name, time, output or numerics only, on the "
           "same grid and with the same relaxation time");
    return differences(parsed(theirs), parsed(ours), is_numerics);
}

std::optional<std::string> setting_in(const std::string& settings, const std::string& key) {
    const Settings all = parsed(settings);
    const auto found = all.find(key);
    return found == all.end() ? std::nullopt : std::optional(std::string(found->second));
}

}  // namespace tt
