#include "coupling/interface/smoothed.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"

namespace tt {
namespace {

/// Eight numbers in one register, or in two or four of the narrower kinds. Written out, because the
/// compiler does not see that the two bounds of t are a minimum and a maximum.
using Lanes = double __attribute__((vector_size(64)));
using LanesInMemory = double __attribute__((vector_size(64), aligned(8), may_alias));
static_assert(sizeof(Lanes) == Patch::lanes * sizeof(double));

/// Lowers `distance2` (same layout as `patch`) to the squared distance of the segment a–b wherever
/// it is smaller. Only the segment's box widened by `reach` is looked at; beyond, the distance is
/// larger than reach. Whole aligned blocks, because the next segment reads back what this one has
/// just written.
TT_INLINE void lower_distance(Vec2 a, Vec2 b, double reach, const Patch& patch, double* distance2) {
    const Lanes lane{0, 1, 2, 3, 4, 5, 6, 7};
    const Lanes zero = lane * 0.0, one = zero + 1.0;
    const Vec2 along = b - a;
    const double length2 = dot(along, along);
    const double inverse = length2 > 0.0 ? 1.0 / length2 : 0.0;
    const Lanes t_of_lane = lane * (along.x * inverse);
    const int first = static_cast<int>(lesser(a.x, b.x) - reach + 0.5) / Patch::lanes;
    const int last = static_cast<int>(greater(a.x, b.x) + reach - 0.5) / Patch::lanes;
    const int bottom = static_cast<int>(lesser(a.y, b.y) - reach + 0.5);
    const int top = static_cast<int>(greater(a.y, b.y) + reach - 0.5);
    for (int block = first; block <= last; ++block) {
        const double x0 = block * Patch::lanes + 0.5 - a.x;
        const Lanes x = lane + x0;
        double* row =
            distance2 + static_cast<std::size_t>(bottom) * patch.width + block * Patch::lanes;
        for (int r = bottom; r <= top; ++r, row += patch.width) {
            const double y = r + 0.5 - a.y;
            Lanes t = t_of_lane + (x0 * along.x + y * along.y) * inverse;
            t = t > zero ? t : zero;
            t = t < one ? t : one;
            const Lanes dx = x - t * along.x;
            const Lanes dy = y - t * along.y;
            const Lanes found = dx * dx + dy * dy;
            auto* const here = reinterpret_cast<LanesInMemory*>(row);
            const Lanes old = *here;
            *here = found < old ? found : old;
        }
    }
}

TT_CLONES void lower_all(const LocalOutline& outline, double reach, const Patch& patch,
                         double* distance2) {
    for (int k = 0; k < outline.segments(); ++k)
        lower_distance({outline.x[k], outline.y[k]}, {outline.x[k + 1], outline.y[k + 1]}, reach,
                       patch, distance2);
}

TT_CLONES void blend(double half_width, const double* distance2, int count, double* value) {
    const double inverse = 1.0 / half_width;
    for (int k = 0; k < count; ++k) {
        const double s = lesser(1.0, std::sqrt(distance2[k]) * inverse);
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
