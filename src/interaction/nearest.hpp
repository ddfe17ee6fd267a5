#pragma once

#include <cstdint>
#include <vector>

#include "base/choice.hpp"
#include "base/vec2.hpp"
#include "membrane/suspension.hpp"

namespace tt {

enum class Nearest : std::uint8_t { node, segment };
template <>
inline constexpr auto words_of<Nearest> = std::to_array<std::string_view>({"node", "segment"});

/// The point of an outline nearest to another point: on segment `segment` (counted from the
/// outline's first node), at its share `along` (0: its first node). Of equally near segments the
/// lowest.
struct NearestPoint {
    double distance2 = 0.0;
    int segment = 0;
    double along = 0.0;
};

/// Segments examined together.
inline constexpr int segments_at_once = 8;

/// Nearest point of `segments_at_once` segments in a row, starting with `first` (0 … size − 1),
/// past the end of the outline continuing at its start.
NearestPoint nearest_in_window(const Outline& outline, Vec2 point, int first, Nearest nearest);

/// The same for several points at once, each with a window of an outline of its own: side by side
/// the arithmetic of eight takes the time of one. Outlines are told by their nodes in two arrays of
/// coordinates.
struct WindowBatch {
    static constexpr int size = 64;
    double x[size], y[size];                           ///< in: the points
    std::int32_t first[size], begin[size], end[size];  ///< in: start of the window; the outline
    double distance2[size], along[size];               ///< out
    std::int32_t segment[size];                        ///< out: the segment's first node
};
void nearest_in_windows(const double* x, const double* y, Nearest nearest, int count,
                        WindowBatch& batch);

/// Bounding boxes of each `segments_at_once` segments of an outline: what lets a search pass over
/// most of it.
struct SegmentBoxes {
    std::vector<double> low_x, high_x, low_y, high_y;
    int count() const { return static_cast<int>(low_x.size()); }
};
void set_boxes(const Outline& outline, SegmentBoxes& boxes);

/// The nearest point of the whole outline, a window of segments around it, and a lower bound of the
/// distance of every segment outside the window (at most `horizon` larger than the nearest
/// distance).
struct SearchResult {
    NearestPoint nearest;
    int window_first = 0;
    double outside = 0.0;
};

/// Searches the outline. The boxes may be old: the nodes have since moved by `drift` and up to
/// `slack` besides. `lower` is a work array of at least boxes.count() numbers.
SearchResult search_nearest(const Outline& outline, const SegmentBoxes& boxes, Vec2 drift,
                            double slack, Vec2 point, Nearest nearest, double horizon,
                            std::vector<double>& lower);

}  // namespace tt
