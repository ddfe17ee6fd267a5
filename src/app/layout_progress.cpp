#include "app/layout_progress.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "io/json.hpp"

namespace tt {

LayoutWatch layout_progress(ProgressMode mode) {
    constexpr double patience = 2.0;  // seconds
    const auto progress = std::make_shared<Progress>(mode);
    const auto started = std::chrono::steady_clock::now();
    return [progress, started, next = patience](int cells, double filled) mutable {
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
        if (seconds < next) return;
        next = seconds + progress->interval();
        const Json json{{"placing_cells", cells}, {"area_share", filled}};
        progress->show(fmt::format("placing {} cells: {:.1f} % of their area", cells,
                                   100.0 * std::min(1.0, filled)),
                       json.dump());
    };
}

}  // namespace tt
