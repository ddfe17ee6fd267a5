#include "interaction/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"

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

TT_INLINE void measure_window(const double* x, const double* y, Vec2 point, double segments_count,
                              double* distance2, double* along) {
#pragma omp simd
    for (int k = 0; k < window; ++k)
        distance2[k] = distance2_to(point.x, point.y, x[k], y[k], x[k + 1], y[k + 1],
                                    segments_count, along[k]);
}

TT_CLONES NearestPoint nearest_of(const double* x, const double* y, Vec2 point,
                                  double segments_count) {
    double distance2[window];
    double along[window];
    measure_window(x, y, point, segments_count, distance2, along);
    double smallest = distance2[0];
    for (int k = 1; k < window; ++k) smallest = lesser(smallest, distance2[k]);
    int at = 0;
    for (int k = window - 1; k >= 0; --k) at = distance2[k] == smallest ? k : at;
    return {smallest, at, along[at]};
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

/// The nodes of `window` segments from `first` on, past the end of the outline from its start.
struct WindowNodes {
    double x[window + 1], y[window + 1];

    WindowNodes(const Outline& outline, int first) {
        const int size = outline.size();
        for (int k = 0, node = first; k <= window; ++k, ++node) {
            if (node >= size) node -= size;
            x[k] = outline.x[node];
            y[k] = outline.y[node];
        }
    }
};

/// The same for a window that reaches past the end of the outline.
NearestPoint nearest_across_start(const Outline& outline, Vec2 point, int first,
                                  double segments_count) {
    const int size = outline.size();
    const WindowNodes nodes(outline, first);
    double distance2[window], along[window];
    measure_window(nodes.x, nodes.y, point, segments_count, distance2, along);
    NearestPoint best{distance2[0], first % size, along[0]};
    for (int k = 1; k < window; ++k) {
        const NearestPoint found{distance2[k], (first + k) % size, along[k]};
        if (before(found, best)) best = found;
    }
    return best;
}

/// First segment of the window with segment `at` in its middle.
int window_around(const NearestPoint& at, int size) {
    const int first = at.segment - (at.along < 0.5 ? window / 2 : window / 2 - 1);
    return first < 0 ? first + size : first;
}

/// Smallest squared distance of those segments of one box that are not in the window.
TT_CLONES double nearest_outside2(const double* x, const double* y, Vec2 point,
                                  double segments_count, int box_offset, int size) {
    double distance2[window], along[window];
    measure_window(x, y, point, segments_count, distance2, along);
    double smallest = HUGE_VAL;
    for (int k = 0; k < window; ++k) {
        const int offset = box_offset + k >= size ? box_offset + k - size : box_offset + k;
        smallest = lesser(smallest, offset < window ? HUGE_VAL : distance2[k]);
    }
    return smallest;
}

double nearest_outside(const Outline& outline, Vec2 point, Nearest nearest, int box,
                       int window_first) {
    const int size = outline.size();
    const int first = box * window;
    const double segments_count = factor_of(nearest);
    const int offset = first - window_first + (first < window_first ? size : 0);
    if (first + window < size)
        return std::sqrt(nearest_outside2(outline.x.data() + first, outline.y.data() + first, point,
                                          segments_count, offset, size));
    const WindowNodes nodes(outline, first);
    return std::sqrt(nearest_outside2(nodes.x, nodes.y, point, segments_count, offset, size));
}

TT_CLONES void look_through_windows(const double* x, const double* y, double segments_count,
                                    int count, WindowBatch& batch) {
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
    for (int k = 0; k < window; ++k) {
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

}  // namespace

void nearest_in_windows(const double* x, const double* y, Nearest nearest, int count,
                        WindowBatch& batch) {
    look_through_windows(x, y, factor_of(nearest), count, batch);
}

NearestPoint nearest_in_window(const Outline& outline, Vec2 point, int first, Nearest nearest) {
    const int size = outline.size();
    const double segments_count = factor_of(nearest);
    if (first + window < size) {
        NearestPoint found =
            nearest_of(outline.x.data() + first, outline.y.data() + first, point, segments_count);
        found.segment += first;
        return found;
    }
    return nearest_across_start(outline, point, first, segments_count);
}

void set_boxes(const Outline& outline, SegmentBoxes& boxes) {
    const int size = outline.size();
    const std::size_t count = (size + window - 1) / window;
    for (auto* side : {&boxes.low_x, &boxes.high_x, &boxes.low_y, &boxes.high_y})
        side->resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        const int begin = static_cast<int>(b) * window;
        Vec2 low = outline[begin], high = low;
        for (int k = begin + 1; k <= std::min(begin + window, size); ++k) {
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
    NearestPoint best = nearest_in_window(outline, point, closest * window, nearest);
    double distance = std::sqrt(best.distance2);
    for (int b = 0; b < count; ++b) {
        if (b == closest || lower[b] > distance) continue;
        const NearestPoint found = nearest_in_window(outline, point, b * window, nearest);
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
