#include "coupling/interface/area_fraction.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"

namespace tt {
namespace {

/// A piece of a segment within one square (c, r): covers `run` (signed, positive to the right) of
/// the width of the column, at mean height `y`. All squares above are covered over the whole run,
/// this one over (r + 1 − y) of it. Stored as increments along y, to be summed later.
TT_INLINE void add_piece(double run, double y, int c, int r, Patch& patch) {
    const double here = run * (r + 1 - y);
    patch.row(r)[c] += here;
    patch.row(r + 1)[c] += run - here;
}

/// The part of a segment within column c, from (x0, y0) to (x1, y1), cut at the rows it passes.
TT_INLINE void add_in_column(double x0, double y0, double x1, double y1, int c, Patch& patch) {
    const bool rises = y1 >= y0;
    const double low = rises ? y0 : y1;
    const double high = rises ? y1 : y0;
    const int first = static_cast<int>(low);
    const int last = static_cast<int>(high);
    const double run = x1 - x0;
    if (first == last) {
        add_piece(run, 0.5 * (low + high), c, first, patch);
        return;
    }
    const double run_per_rise = run / (high - low);
    double y = low;
    for (int r = first; r <= last; ++r) {
        const double top = std::min<double>(r + 1, high);
        add_piece((top - y) * run_per_rise, 0.5 * (y + top), c, r, patch);
        y = top;
    }
}

void add_segment(Vec2 a, Vec2 b, Patch& patch) {
    const bool forward = b.x >= a.x;
    const Vec2 left = forward ? a : b;
    const Vec2 right = forward ? b : a;
    const int first = static_cast<int>(left.x);
    const int last = static_cast<int>(right.x);
    if (first == last) {
        add_in_column(a.x, a.y, b.x, b.y, first, patch);
        return;
    }
    const double slope = (right.y - left.y) / (right.x - left.x);
    double x = left.x;
    double y = left.y;
    for (int c = first; c <= last; ++c) {
        const double x1 = c == last ? right.x : c + 1.0;
        const double y1 = c == last ? right.y : left.y + (x1 - left.x) * slope;
        if (forward)
            add_in_column(x, y, x1, y1, c, patch);
        else
            add_in_column(x1, y1, x, y, c, patch);
        x = x1;
        y = y1;
    }
}

}  // namespace

void AreaFraction::cover(const LocalOutline& outline, Patch& patch) {
    for (int k = 0; k < outline.segments(); ++k)
        add_segment({outline.x[k], outline.y[k]}, {outline.x[k + 1], outline.y[k + 1]}, patch);
    sum_along_y(patch);
}

}  // namespace tt
