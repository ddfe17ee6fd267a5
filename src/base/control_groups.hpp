#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// The folders of the control groups that bound this process in `controller` ("cpu", "memory"):
/// those in `membership` (the text of /proc/self/cgroup) and all above them, under `mount`
/// (/sys/fs/cgroup). Of version 2 and of version 1, where `controller` is among those of the line.
std::vector<std::filesystem::path> control_groups(const std::filesystem::path& mount,
                                                  std::string_view membership,
                                                  std::string_view controller);

/// The same, of this process on this machine.
std::vector<std::filesystem::path> control_groups(std::string_view controller);

/// The first word of a file; empty where there is none.
std::string first_word_of(const std::filesystem::path& file);

}  // namespace tt
