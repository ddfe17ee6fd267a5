#include "coupling/interface/smoothed.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"

namespace tt {
namespace {

/// Lowers `distance2` (same layout as `patch`) to the squared distance of the segment wherever it is smaller. Only
/// sites in the segment's box widened by `reach` are looked at; beyond, the distance is larger than reach.
TT_INLINE void lower_distance(Vec2 a, Vec2 b, double reach, const Patch& patch, double* distance2) {
    const Vec2 along = b - a;
    const double length2 = dot(along, along);
    const double inverse = length2 > 0.0 ? 1.0 / length2 : 0.0;
    const int c0 = static_cast<int>(std::min(a.x, b.x) - reach);
    const int c1 = static_cast<int>(std::max(a.x, b.x) + reach) + 1;
    const int r0 = static_cast<int>(std::min(a.y, b.y) - reach);
    const int r1 = static_cast<int>(std::max(a.y, b.y) + reach) + 1;
    const int blocks = (c1 - c0 + Patch::lanes - 1) / Patch::lanes;
    for (int r = r0; r < r1; ++r) {
        const double y = r + 0.5 - a.y;
        double* row = distance2 + static_cast<std::size_t>(r) * patch.width;
        for (int block = 0; block < blocks; ++block) {
            const int first = std::min(c0 + block * Patch::lanes, patch.width - Patch::lanes);
#pragma omp simd
            for (int lane = 0; lane < Patch::lanes; ++lane) {
                const double x = first + lane + 0.5 - a.x;
                const double t = std::min(1.0, std::max(0.0, (x * along.x + y * along.y) * inverse));
                const double dx = x - t * along.x;
                const double dy = y - t * along.y;
                row[first + lane] = std::min(row[first + lane], dx * dx + dy * dy);
            }
        }
    }
}

TT_CLONES void lower_all(const LocalOutline& outline, double reach, const Patch& patch, double* distance2) {
    for (int k = 0; k < outline.segments(); ++k)
        lower_distance({outline.x[k], outline.y[k]}, {outline.x[k + 1], outline.y[k + 1]}, reach, patch, distance2);
}

TT_CLONES void blend(double half_width, const double* distance2, int count, double* value) {
    const double inverse = 1.0 / half_width;
    for (int k = 0; k < count; ++k) {
        const double s = std::min(1.0, std::sqrt(distance2[k]) * inverse);
        const double s2 = s * s;
        const double step = s * (15.0 - s2 * (10.0 - 3.0 * s2)) * (1.0 / 16.0);
        value[k] = 0.5 + (value[k] > 0.5 ? step : -step);
    }
}

}  // namespace

void SmoothedInterface::smooth(const LocalOutline& outline, Patch& patch) const {
    patch.work.assign(patch.value.size(), half_width * half_width);
    lower_all(outline, half_width, patch, patch.work.data());
    blend(half_width, patch.work.data(), static_cast<int>(patch.value.size()), patch.value.data());
}

}  // namespace tt
