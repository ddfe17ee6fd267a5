#include "base/control_groups.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Is it one of "cpu,cpuacct"?
bool is_among(std::string_view word, std::string_view list) {
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        if (list.substr(0, comma) == word) return true;
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return false;
}

}  // namespace

std::vector<fs::path> control_groups(const fs::path& mount, std::string_view membership,
                                     std::string_view controller) {
    std::vector<fs::path> groups;
    while (!membership.empty()) {
        const std::size_t end = std::min(membership.find('\n'), membership.size());
        const std::string_view line = membership.substr(0, end);
        membership.remove_prefix(std::min(end + 1, membership.size()));
        // "0::/path" of version 2, "4:cpu,cpuacct:/path" of version 1
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == line.npos || second == line.npos) continue;
        const std::string_view controllers = line.substr(first + 1, second - first - 1);
        if (!controllers.empty() && !is_among(controller, controllers)) continue;
        fs::path group = mount / controllers;
        groups.push_back(group);
        for (const fs::path& part : fs::path(line.substr(second + 1)).relative_path())
            groups.push_back(group /= part);
    }
    return groups;
}

std::vector<fs::path> control_groups(std::string_view controller) {
    std::ifstream file("/proc/self/cgroup");
    const std::string membership{std::istreambuf_iterator<char>(file), {}};
    return control_groups("/sys/fs/cgroup", membership, controller);
}

std::string first_word_of(const fs::path& path) {
    std::ifstream file(path);
    std::string word;
    file >> word;
    return word;
}

}  // namespace tt
