#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "fluid/walls.hpp"
#include "geometry/loops.hpp"
#include "grid/lattice.hpp"

namespace tt {

/// Wall segments by the square of sites that they pass, so that a link looks at few.
class WallBins {
public:
    /// Precondition: the segments outlive the bins.
    WallBins(const std::vector<WallSegment>& segments, const Lattice& lattice)
        : segments_(segments),
          columns_((lattice.nx + 2 * margin) / side + 1),
          rows_((lattice.ny + 2 * margin) / side + 1),
          bins_(static_cast<std::size_t>(columns_) * rows_) {
        for (std::size_t s = 0; s < segments.size(); ++s) {
            const auto& [a, b, loop, opening] = segments[s];
            const int i0 = column(std::min(a.x, b.x)), i1 = column(std::max(a.x, b.x));
            const int j0 = row(std::min(a.y, b.y)), j1 = row(std::max(a.y, b.y));
            for (int j = j0; j <= j1; ++j)
                for (int i = i0; i <= i1; ++i)
                    if (passes(a, b, i, j)) bin(i, j).push_back(static_cast<int>(s));
        }
    }

    struct Meeting {
        double share;  ///< of the way
        int loop;
        int opening;  ///< or −1
    };
    /// Where the way from a to b, of a site or so, first meets a wall.
    std::optional<Meeting> first_meeting(Vec2 a, Vec2 b) const {
        std::optional<Meeting> first;
        const int i0 = column(std::min(a.x, b.x)), i1 = column(std::max(a.x, b.x));
        const int j0 = row(std::min(a.y, b.y)), j1 = row(std::max(a.y, b.y));
        for (int j = j0; j <= j1; ++j)
            for (int i = i0; i <= i1; ++i)
                for (const int s : bin(i, j)) {
                    const double share = meeting(a, b, segments_[s]);
                    if (share < 0.0 || (first && first->share <= share)) continue;
                    first = Meeting{share, segments_[s].loop, segments_[s].opening};
                }
        return first;
    }

    /// The segments in and around the square of `point`; some come more than once.
    template <class F>
    void for_each_near(Vec2 point, F&& f) const {
        const int i0 = column(point.x), j0 = row(point.y);
        for (int j = std::max(0, j0 - 1); j <= std::min(rows_ - 1, j0 + 1); ++j)
            for (int i = std::max(0, i0 - 1); i <= std::min(columns_ - 1, i0 + 1); ++i)
                for (const int s : bin(i, j)) f(s);
    }

private:
    static constexpr int side = 4, margin = 4;

    int column(double x) const {
        return std::clamp(static_cast<int>(std::floor((x + margin) / side)), 0, columns_ - 1);
    }
    int row(double y) const {
        return std::clamp(static_cast<int>(std::floor((y + margin) / side)), 0, rows_ - 1);
    }
    std::vector<int>& bin(int i, int j) {
        return bins_[static_cast<std::size_t>(j) * columns_ + i];
    }
    const std::vector<int>& bin(int i, int j) const {
        return bins_[static_cast<std::size_t>(j) * columns_ + i];
    }
    /// Does the segment come into the square, with a little to spare? Edge squares hold what lies
    /// outside, too.
    bool passes(Vec2 a, Vec2 b, int i, int j) const {
        if (i == 0 || j == 0 || i == columns_ - 1 || j == rows_ - 1) return true;
        const Vec2 middle{(i + 0.5) * side - margin, (j + 0.5) * side - margin};
        const Vec2 along = b - a;
        const double off = std::fabs(cross(along, middle - a));
        return off <= 0.75 * side * (std::fabs(along.x) + std::fabs(along.y));
    }

    const std::vector<WallSegment>& segments_;
    int columns_, rows_;
    std::vector<std::vector<int>> bins_;
};

/// Fills `walls.distance`, of which all else is known.
void measure_distances(const WallBins& bins, Walls& walls);

}  // namespace tt
