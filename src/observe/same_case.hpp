#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tt {

/// Throws DirectoryInUse unless the results in `directory`, of the settings `theirs`, are of a run
/// that `ours` can go on with: the name, `time.*` and `output.*` may differ, for no state depends
/// on them. The message has every key that differs otherwise, with both values. Settings are lines
/// `table.key = value`.
void expect_same_case(const std::filesystem::path& directory, const std::string& theirs,
                      const std::string& ours);

/// A setting that changes, with both values as they are written.
struct SettingChange {
    std::string key, before, after;
};

/// The same for a run that blew up, where settings of the numerics may differ too, as long as a
/// state can be taken over: not the grid, nor the relaxation time. Returns those that do.
std::vector<SettingChange> changed_numerics(const std::filesystem::path& directory,
                                            const std::string& theirs, const std::string& ours);

/// The value of a key in settings, as it is written.
std::optional<std::string> setting_in(const std::string& settings, const std::string& key);

}  // namespace tt
