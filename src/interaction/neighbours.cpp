#include "interaction/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace tt {
namespace {

/// Whole periods m for which [low, high] + m·period comes within reach of [from, to].
struct Periods {
    int first = 0, last = 0;
};

Periods periods_near(double low, double high, double from, double to, double reach, double period) {
    return {static_cast<int>(std::ceil((from - reach - high) / period)),
            static_cast<int>(std::floor((to + reach - low) / period))};
}

/// Bins to look at along one axis: the one given and its two neighbours, each once.
struct BinRange {
    int list[3];
    int count;
};

BinRange around(int bin, int count) {
    if (count == 1) return {{bin, 0, 0}, 1};
    if (count == 2) return {{0, 1, 0}, 2};
    return {{(bin + count - 1) % count, bin, (bin + 1) % count}, 3};
}

}  // namespace

Bounds bounds_of(const Outline& outline, const Lattice& lattice) {
    Bounds b{outline[0], outline[0], false};
    double nought = 0.0;  // stays 0 unless a value is NaN or infinite
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 p = outline[k];
        b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y)};
        b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y)};
        nought += (p.x + p.y) * 0.0;
    }
    const double limit = 4.0 * std::max(lattice.nx, lattice.ny);
    const auto sane = [](Vec2 p) { return std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9; };
    b.usable = nought == 0.0 && sane(b.low) && sane(b.high) && b.high.x - b.low.x < limit &&
               b.high.y - b.low.y < limit;
    return b;
}

int CellBins::bin_along(double at, double period, int count) const {
    const double place = at / period - std::floor(at / period);
    return std::clamp(static_cast<int>(place * count), 0, count - 1);
}

void CellBins::sort(const Lattice& lattice, const std::vector<Bounds>& bounds, double reach) {
    lattice_ = lattice;
    bounds_ = bounds;
    reach_ = reach;
    double size = 1.0;  // boxes whose corners are two bins apart cannot be within reach
    for (const Bounds& b : bounds)
        if (b.usable)
            size = std::max({size, b.high.x - b.low.x + reach, b.high.y - b.low.y + reach});
    nx_ = std::max(1, static_cast<int>(lattice.nx / size));
    ny_ = std::max(1, static_cast<int>(lattice.ny / size));
    const std::size_t n = bounds.size();
    bin_.assign(n, -1);
    const std::size_t bins = static_cast<std::size_t>(nx_) * ny_;
    if (first_.capacity() <= bins) first_.reserve(4 * bins + 1);  // boxes shrink and grow in a run
    first_.assign(bins + 1, 0);
    for (std::size_t c = 0; c < n; ++c) {
        if (!bounds[c].usable) continue;
        bin_[c] = bin_along(bounds[c].low.y, lattice.ny, ny_) * nx_ +
                  bin_along(bounds[c].low.x, lattice.nx, nx_);
        ++first_[bin_[c] + 1];
    }
    for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    cells_.resize(n);
    for (std::size_t c = 0; c < n; ++c)
        if (bin_[c] >= 0) cells_[first_[bin_[c]]++] = static_cast<std::int32_t>(c);
    for (std::size_t b = first_.size() - 1; b > 0; --b) first_[b] = first_[b - 1];
    first_[0] = 0;
}

void CellBins::add_images(int cell, int other, std::vector<Neighbour>& result) const {
    const Bounds& a = bounds_[cell];
    const Bounds& b = bounds_[other];
    const Periods px = periods_near(b.low.x, b.high.x, a.low.x, a.high.x, reach_, lattice_.nx);
    Periods py = periods_near(b.low.y, b.high.y, a.low.y, a.high.y, reach_, lattice_.ny);
    if (lattice_.walls) py = {std::max(py.first, 0), std::min(py.last, 0)};
    for (int my = py.first; my <= py.last; ++my) {
        for (int mx = px.first; mx <= px.last; ++mx) {
            if (other == cell && mx == 0 && my == 0) continue;
            result.push_back(
                {other,
                 {static_cast<double>(mx) * lattice_.nx, static_cast<double>(my) * lattice_.ny}});
        }
    }
}

void CellBins::near(int cell, std::vector<Neighbour>& result) const {
    result.clear();
    if (bin_[cell] < 0) return;
    const BinRange columns = around(bin_[cell] % nx_, nx_);
    const BinRange rows = around(bin_[cell] / nx_, ny_);
    for (int r = 0; r < rows.count; ++r) {
        for (int c = 0; c < columns.count; ++c) {
            const int bin = rows.list[r] * nx_ + columns.list[c];
            for (int k = first_[bin]; k < first_[bin + 1]; ++k) add_images(cell, cells_[k], result);
        }
    }
    std::sort(result.begin(), result.end(), [](const Neighbour& a, const Neighbour& b) {
        if (a.cell != b.cell) return a.cell < b.cell;
        return a.shift.y != b.shift.y ? a.shift.y < b.shift.y : a.shift.x < b.shift.x;
    });
}

}  // namespace tt
