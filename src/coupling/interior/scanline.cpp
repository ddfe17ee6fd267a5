#include "coupling/interior/scanline.hpp"

#include <algorithm>

#include "base/isa.hpp"
#include "coupling/interior/crossing.hpp"

namespace tt {
namespace {

/// First row whose site in the column at x lies above the segment. The division may be off by one
/// row where the crossing is close to a site; the exact test settles it.
int first_row_above(Vec2 a, Vec2 b, double x) {
    const double crossing = a.y + (x - a.x) * ((b.y - a.y) / (b.x - a.x));
    int r = static_cast<int>(std::ceil(crossing - 0.5));
    while (above(a, b, {x, r - 0.5})) --r;
    while (!above(a, b, {x, r + 0.5})) ++r;
    return r;
}

}  // namespace

void ScanLine::operator()(const LocalOutline& outline, Patch& patch) const {
    Vec2 a{snapped(outline.x[0]), snapped(outline.y[0])};
    for (int k = 0; k < outline.segments(); ++k) {
        const Vec2 b{snapped(outline.x[k + 1]), snapped(outline.y[k + 1])};
        const int begin = static_cast<int>(std::ceil(std::min(a.x, b.x) - 0.5));
        const int end = static_cast<int>(std::ceil(std::max(a.x, b.x) - 0.5));
        // Counter-clockwise: the lower side runs to larger x, and above it one is inside.
        const double step = a.x < b.x ? 1.0 : -1.0;
        for (int c = begin; c < end; ++c) patch.row(first_row_above(a, b, c + 0.5))[c] += step;
        a = b;
    }
    sum_along_y(patch);
}

}  // namespace tt
