#include "base/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "base/control_groups.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

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
    return processors(first_word_of(group / "cpu.cfs_quota_us"),
                      first_word_of(group / "cpu.cfs_period_us"));
}

int lesser_quota(int a, int b) { return a == 0 || (b != 0 && b < a) ? b : a; }

int processors_by_affinity() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
    return static_cast<int>(std::thread::hardware_concurrency());  // more than 1024 of them
}

}  // namespace

int processors_by_quota(const std::vector<fs::path>& groups) {
    int smallest = 0;
    for (const fs::path& group : groups) smallest = lesser_quota(smallest, quota_of(group));
    return smallest;
}

int threads_for(std::int64_t sites, std::int64_t nodes, int usable) {
    constexpr std::int64_t node = 50, share = 3'000;  // what a node and a thread's part are worth
    return static_cast<int>(std::clamp<std::int64_t>((sites + node * nodes) / share, 1, usable));
}

int usable_processors() {
    const int allowed = std::max(1, processors_by_affinity());
    const int quota = processors_by_quota(control_groups("cpu"));
    return quota == 0 ? allowed : std::min(allowed, quota);
}

}  // namespace tt
