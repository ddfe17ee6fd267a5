#include "base/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "base/control_groups.hpp"

namespace tt {

double memory_by_limit(const std::vector<std::filesystem::path>& groups) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& group : groups) {
        for (const char* name : {"memory.max", "memory.limit_in_bytes"}) {
            // "max" and "-1": none. Version 1 writes a number near 2^63 for none.
            const double limit = std::strtod(first_word_of(group / name).c_str(), nullptr);
            if (limit > 0.0) smallest = std::min(smallest, limit);
        }
    }
    return smallest;
}

double free_memory() {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (double kilobytes = 0.0; file >> name >> kilobytes; std::getline(file, unit))
        if (name == "MemAvailable:") return 1024.0 * kilobytes;
    return std::numeric_limits<double>::infinity();
}

double usable_memory() {
    double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                   static_cast<double>(::sysconf(_SC_PAGESIZE));
    for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
        struct rlimit limit {};
        if (::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
            bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
    }
    return std::min(bytes, memory_by_limit(control_groups("memory")));
}

}  // namespace tt
