#include "interaction/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "grid/lattice.hpp"

namespace tt {
namespace {

double factor_of(Nearest nearest) { return nearest == Nearest::segment ? 1.0 : 0.0; }

/// Squared distance of a point to the segment from (x0, y0) to (x1, y1), and where on it. Where
/// only nodes count, `segments_count` is 0 and the place the first node.
TT_INLINE double distance2_to(double px, double py, double x0, double y0, double x1, double y1,
                              double segments_count, double& along) {
    const double ax = x0 - px;
    const double ay = y0 - py;
    const double ex = x1 - x0;
    const double ey = y1 - y0;
    const double length2 = ex * ex + ey * ey;
    // Two nodes on one spot make a segment of no length: any place on it will do.
    const double place = -(ax * ex + ay * ey) / greater(length2, 1e-300);
    along = segments_count * lesser(1.0, greater(0.0, place));
    const double dx = ax + along * ex;
    const double dy = ay + along * ey;
    return dx * dx + dy * dy;
}

/// The nodes of `segments_at_once` segments from `first` on, past the end of the outline from its
/// start.
struct WindowNodes {
    double x[segments_at_once + 1], y[segments_at_once + 1];

    WindowNodes(const Outline& outline, int first) {
        const int size = outline.size();
        for (int k = 0, node = first; k <= segments_at_once; ++k, ++node) {
            if (node >= size) node -= size;
            x[k] = outline.x[node];
            y[k] = outline.y[node];
        }
    }
};

/// Squared distance of a point to each of the window's segments, and where on it.
TT_CLONES void measure_window(const WindowNodes& nodes, Vec2 point, double segments_count,
                              double* distance2, double* along) {
#pragma omp simd
    for (int k = 0; k < segments_at_once; ++k)
        distance2[k] = distance2_to(point.x, point.y, nodes.x[k], nodes.y[k], nodes.x[k + 1],
                                    nodes.y[k + 1], segments_count, along[k]);
}

/// Is `a` nearer, or as near and before `b`?
bool before(const NearestPoint& a, const NearestPoint& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.segment < b.segment);
}

TT_CLONES void lower_bounds(const SegmentBoxes& boxes, Vec2 point, double slack, double* lower) {
    const int count = boxes.count();
    for (int b = 0; b < count; ++b) {
        const double dx =
            greater(0.0, greater(boxes.low_x[b] - point.x, point.x - boxes.high_x[b]));
        const double dy =
            greater(0.0, greater(boxes.low_y[b] - point.y, point.y - boxes.high_y[b]));
        lower[b] = greater(0.0, std::sqrt(dx * dx + dy * dy) - slack);
    }
}

/// First segment of the window with segment `at` in its middle.
int window_around(const NearestPoint& at, int size) {
    const int first =
        at.segment - (at.along < 0.5 ? segments_at_once / 2 : segments_at_once / 2 - 1);
    return first < 0 ? first + size : first;
}

/// Smallest distance of those segments of one box that are not in the window.
double nearest_outside(const Outline& outline, Vec2 point, Nearest nearest, int box,
                       int window_first) {
    const int size = outline.size();
    const int first = box * segments_at_once;
    double distance2[segments_at_once], along[segments_at_once];
    measure_window({outline, first}, point, factor_of(nearest), distance2, along);
    double smallest = HUGE_VAL;
    for (int k = 0; k < segments_at_once; ++k) {
        const int offset = wrapped(first + k - window_first, size);
        if (offset >= segments_at_once) smallest = std::min(smallest, distance2[k]);
    }
    return std::sqrt(smallest);
}

}  // namespace

TT_CLONES void nearest_in_windows(const double* x, const double* y, Nearest nearest, int count,
                                  WindowBatch& batch) {
    const double segments_count = factor_of(nearest);
    double x0[WindowBatch::size], y0[WindowBatch::size];
    double segment[WindowBatch::size];
    std::int32_t node[WindowBatch::size];
#pragma omp simd
    for (int p = 0; p < count; ++p) {
        node[p] = batch.first[p];
        x0[p] = x[node[p]];
        y0[p] = y[node[p]];
        batch.distance2[p] = HUGE_VAL;
        batch.along[p] = 0.0;
        segment[p] = 0.0;
    }
    for (int k = 0; k < segments_at_once; ++k) {
#pragma omp simd
        for (int p = 0; p < count; ++p) {
            const std::int32_t next = node[p] + 1 == batch.end[p] ? batch.begin[p] : node[p] + 1;
            const double x1 = x[next], y1 = y[next];
            double along;
            const double d2 =
                distance2_to(batch.x[p], batch.y[p], x0[p], y0[p], x1, y1, segments_count, along);
            const double here = node[p];
            const bool nearer =
                (d2 < batch.distance2[p]) | ((d2 == batch.distance2[p]) & (here < segment[p]));
            batch.distance2[p] = nearer ? d2 : batch.distance2[p];
            batch.along[p] = nearer ? along : batch.along[p];
            segment[p] = nearer ? here : segment[p];
            node[p] = next;
            x0[p] = x1;
            y0[p] = y1;
        }
    }
    for (int p = 0; p < count; ++p) batch.segment[p] = static_cast<std::int32_t>(segment[p]);
}

NearestPoint nearest_in_window(const Outline& outline, Vec2 point, int first, Nearest nearest) {
    double distance2[segments_at_once], along[segments_at_once];
    measure_window({outline, first}, point, factor_of(nearest), distance2, along);
    NearestPoint best{distance2[0], first, along[0]};
    for (int k = 1; k < segments_at_once; ++k) {
        const NearestPoint found{distance2[k], wrapped(first + k, outline.size()), along[k]};
        if (before(found, best)) best = found;
    }
    return best;
}

void set_boxes(const Outline& outline, SegmentBoxes& boxes) {
    const int size = outline.size();
    const std::size_t count = (size + segments_at_once - 1) / segments_at_once;
    for (auto* side : {&boxes.low_x, &boxes.high_x, &boxes.low_y, &boxes.high_y})
        side->resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        const int begin = static_cast<int>(b) * segments_at_once;
        Vec2 low = outline[begin], high = low;
        for (int k = begin + 1; k <= std::min(begin + segments_at_once, size); ++k) {
            const Vec2 p = outline[k < size ? k : 0];
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        boxes.low_x[b] = low.x;
        boxes.low_y[b] = low.y;
        boxes.high_x[b] = high.x;
        boxes.high_y[b] = high.y;
    }
}

SearchResult search_nearest(const Outline& outline, const SegmentBoxes& boxes, Vec2 drift,
                            double slack, Vec2 point, Nearest nearest, double horizon,
                            std::vector<double>& lower) {
    const int count = boxes.count();
    lower_bounds(boxes, point - drift, slack, lower.data());
    const int closest =
        static_cast<int>(std::min_element(lower.begin(), lower.begin() + count) - lower.begin());
    NearestPoint best = nearest_in_window(outline, point, closest * segments_at_once, nearest);
    double distance = std::sqrt(best.distance2);
    for (int b = 0; b < count; ++b) {
        if (b == closest || lower[b] > distance) continue;
        const NearestPoint found = nearest_in_window(outline, point, b * segments_at_once, nearest);
        if (!before(found, best)) continue;
        best = found;
        distance = std::sqrt(best.distance2);
    }
    SearchResult result{best, window_around(best, outline.size()), distance + horizon};
    for (int b = 0; b < count; ++b) {
        if (lower[b] >= result.outside) continue;
        result.outside = std::min(result.outside,
                                  nearest_outside(outline, point, nearest, b, result.window_first));
    }
    return result;
}

}  // namespace tt
