#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec2.hpp"
#include "grid/lattice.hpp"

namespace tt {

/// Points of a box, each found from nearby at a cost that does not grow with their number. They may
/// be moved one at a time.
class CentreBins {
public:
    /// Points within `reach` of each other are found.
    CentreBins(const Lattice& box, double reach)
        : box_(box),
          nx_(std::clamp(static_cast<int>(box.nx / reach), 1, 1024)),
          ny_(std::clamp(static_cast<int>(box.ny / reach), 1, 1024)),
          bins_(static_cast<std::size_t>(nx_) * ny_) {}

    void add(int point, Vec2 at) { bin_of(at).push_back(point); }

    void move(int point, Vec2 from, Vec2 to) {
        std::vector<int>& old = bin_of(from);
        std::vector<int>& fresh = bin_of(to);
        if (&old == &fresh) return;
        old.erase(std::find(old.begin(), old.end(), point));
        fresh.push_back(point);
    }

    /// Whether `f` is true of every point that may be within reach of `at`.
    template <class F>
    bool all_near(Vec2 at, F&& f) const {
        const int i = bin_along(at.x, box_.nx, nx_), j = bin_along(at.y, box_.ny, ny_);
        for (int row = j - std::min(1, ny_ - 1); row <= j + (ny_ > 2 ? 1 : 0); ++row)
            for (int column = i - std::min(1, nx_ - 1); column <= i + (nx_ > 2 ? 1 : 0); ++column)
                for (const int point : bins_[wrapped(row, ny_) * nx_ + wrapped(column, nx_)])
                    if (!f(point)) return false;
        return true;
    }

private:
    static int bin_along(double at, double period, int count) {
        const double place = at / period - std::floor(at / period);
        return std::clamp(static_cast<int>(place * count), 0, count - 1);
    }
    std::vector<int>& bin_of(Vec2 at) {
        return bins_[bin_along(at.y, box_.ny, ny_) * nx_ + bin_along(at.x, box_.nx, nx_)];
    }

    Lattice box_;
    int nx_, ny_;
    std::vector<std::vector<int>> bins_;
};

}  // namespace tt
