#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "io/hdf5_input.hpp"

namespace tt {

/// What frames.h5 says of the run as a whole, SI.
struct FrameGrid {
    int nx = 0, ny = 0;
    double dx = 0.0;              ///< site spacing [m]
    double length = 0.0, width = 0.0;
    std::vector<int> first;       ///< nodes of cell c are first[c] … first[c+1]

    int cell_count() const { return first.empty() ? 0 : static_cast<int>(first.size()) - 1; }
    int node_count() const { return first.empty() ? 0 : first.back(); }
};

/// Membranes and fields at one time, SI. Fields are row after row from the bottom wall, ny × nx; a field that the
/// run did not write is empty. Node positions are unwrapped in x.
struct Frame {
    double time = 0.0;
    std::int64_t step = 0;
    std::vector<Vec2> nodes, node_force, node_velocity;
    std::vector<float> velocity_x, velocity_y;  ///< [m/s]
    std::vector<float> density, pressure, fraction;
};

/// frames.h5 of a results directory. A frame that a killed run left incomplete is not counted.
class FrameFile {
public:
    /// Throws IoError: missing or damaged file.
    explicit FrameFile(const std::filesystem::path& path);

    const FrameGrid& grid() const { return grid_; }
    int count() const { return static_cast<int>(names_.size()); }
    double time(int frame) const { return times_[static_cast<std::size_t>(frame)]; }
    /// The frame nearest to a time [s]. Precondition: count() > 0.
    int nearest(double time) const;
    Frame read(int frame) const;
    /// The membrane alone, for when the fields are not needed.
    std::vector<Vec2> read_nodes(int frame) const;
    /// Length of every segment at rest [m], by its first node; empty if the run did not write it.
    const std::vector<double>& rest_length() const { return rest_length_; }

private:
    std::vector<float> field(const std::string& name) const;
    std::vector<Vec2> vectors(const std::string& name) const;

    Hdf5Input file_;
    FrameGrid grid_;
    std::vector<double> rest_length_;
    std::vector<std::string> names_;
    std::vector<double> times_;
};

/// Moves a cell by whole lengths of the box so that the mean of its nodes lies in 0 ≤ x < length.
void wrap_cell(std::vector<Vec2>& nodes, int begin, int end, double length);

}  // namespace tt
