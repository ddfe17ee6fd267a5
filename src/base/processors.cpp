#include "base/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace tt {
namespace {

namespace fs = std::filesystem;

/// The first word of a file; empty where there is none.
std::string word_of(const fs::path& path) {
    std::ifstream file(path);
    std::string word;
    file >> word;
    return word;
}

/// Processors from a quota and its period [µs]; 0: none.
int processors(const std::string& quota, const std::string& period) {
    const double allowed = std::strtod(quota.c_str(), nullptr);  // "max" and "-1": none
    const double of = std::strtod(period.c_str(), nullptr);
    if (!(allowed > 0.0) || !(of > 0.0)) return 0;
    return static_cast<int>(std::min(std::ceil(allowed / of), 1e6));
}

int quota_of(const fs::path& group) {
    std::ifstream file(group / "cpu.max");
    std::string quota, period;
    if (file >> quota >> period) return processors(quota, period);
    return processors(word_of(group / "cpu.cfs_quota_us"), word_of(group / "cpu.cfs_period_us"));
}

int lesser_quota(int a, int b) { return a == 0 || (b != 0 && b < a) ? b : a; }

/// Of the group `path` under `mount` and all above it.
int quota_on_the_way(const fs::path& mount, const fs::path& path) {
    int smallest = quota_of(mount);
    fs::path group = mount;
    for (const fs::path& part : path.relative_path())
        smallest = lesser_quota(smallest, quota_of(group /= part));
    return smallest;
}

int processors_by_affinity() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
    return static_cast<int>(std::thread::hardware_concurrency());  // more than 1024 of them
}

std::string text_of(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

int processors_by_quota(const fs::path& mount, std::string_view membership) {
    int smallest = 0;
    while (!membership.empty()) {
        const std::size_t end = std::min(membership.find('\n'), membership.size());
        const std::string_view line = membership.substr(0, end);
        membership.remove_prefix(std::min(end + 1, membership.size()));
        // "0::/path" of version 2, "4:cpu,cpuacct:/path" of version 1
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == line.npos || second == line.npos) continue;
        const std::string_view controllers = line.substr(first + 1, second - first - 1);
        const fs::path path(line.substr(second + 1));
        if (controllers.empty() || controllers.find("cpu") != controllers.npos)
            smallest = lesser_quota(smallest, quota_on_the_way(mount / controllers, path));
    }
    return smallest;
}

int threads_for(std::int64_t sites, std::int64_t nodes, int usable) {
    constexpr std::int64_t node = 50, share = 10'000;  // what a node and a thread's part are worth
    return static_cast<int>(std::clamp<std::int64_t>((sites + node * nodes) / share, 1, usable));
}

int usable_processors() {
    const int allowed = std::max(1, processors_by_affinity());
    const int quota = processors_by_quota("/sys/fs/cgroup", text_of("/proc/self/cgroup"));
    return quota == 0 ? allowed : std::min(allowed, quota);
}

}  // namespace tt
