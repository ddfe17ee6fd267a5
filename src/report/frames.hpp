#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "io/frames.hpp"

namespace tt {

/// Of the frames that hold fields, the one nearest to a time [s]; nothing if there is none.
std::optional<int> nearest_field(const FramesReader& frames, double time);

/// Node positions of a frame [m], each cell moved by whole lengths and widths of the box so that
/// the mean of its nodes lies in it. (Between walls a cell never leaves along y.)
std::vector<Vec2> wrapped_nodes(const FramesHeader& header, const Frame& frame);

/// Length of the segment that starts at each node [m].
std::vector<double> segment_lengths(const FramesHeader& header, const Frame& frame);

/// By how much to move a cell of `wrapped_nodes` [m] to draw it and its images that reach into the
/// box: 0 first, then whole lengths and widths of the box; nothing of a cell that has left.
std::vector<Vec2> image_shifts(const FramesHeader& header, const std::vector<Vec2>& wrapped,
                               int cell);

/// The frames of a results directory; tells the user what is damaged. Throws IoError if none can be
/// read.
std::unique_ptr<const FramesReader> open_frames(const std::filesystem::path& directory);

/// Names of the kinds of cells; one without a name where they are all alike.
std::vector<std::string> kind_names(const FramesHeader& header);

inline int cell_count(const FramesHeader& header) {
    return static_cast<int>(header.first.size()) - 1;
}

}  // namespace tt
