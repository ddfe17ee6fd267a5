#include "observe/observer.hpp"

#include <cmath>

#include <fmt/format.h>

namespace tt {

double interval_in(const ArchiveReader& archive, std::string_view name) {
    const auto interval = archive.value<double>(name);
    if (!(interval > 0.0) || !std::isfinite(interval))
        throw DamagedArchive(
            fmt::format("the checkpoint cannot be loaded: '{}' is {} s", name, interval));
    return interval;
}

}  // namespace tt
