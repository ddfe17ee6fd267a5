#pragma once

#include <filesystem>
#include <string>

namespace tt {

/// Throws DirectoryInUse unless the results in `directory`, of the settings `theirs`, are of a run
/// that `ours` can go on with: the name, `time.*` and `output.*` may differ, for no state depends
/// on them. The message has every key that differs otherwise, with both values. Settings are lines
/// `table.key = value`.
void expect_same_case(const std::filesystem::path& directory, const std::string& theirs,
                      const std::string& ours);

}  // namespace tt
