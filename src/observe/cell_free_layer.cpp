#include "observe/cell_free_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/undefined.hpp"

namespace tt {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Lowest and highest membrane on the line through a column of sites.
struct Envelope {
    double low = infinity;
    double high = -infinity;
};

/// Widens the envelope of every column that the segment a → b crosses.
void widen(std::vector<Envelope>& envelope, Vec2 a, Vec2 b) {
    const int columns = static_cast<int>(envelope.size());
    const int first = static_cast<int>(std::ceil(std::min(a.x, b.x) - 0.5));
    const int last = static_cast<int>(std::floor(std::max(a.x, b.x) - 0.5));
    for (int i = first; i <= last; ++i) {
        const double t = a.x == b.x ? 0.0 : (i + 0.5 - a.x) / (b.x - a.x);
        const double y = a.y + t * (b.y - a.y);
        Envelope& column = envelope[wrapped(i, columns)];
        column.low = std::min(column.low, y);
        column.high = std::max(column.high, y);
    }
}

/// Distance from the start of the profile to where it reaches half of `peak`, rows at ½, 3/2, …
template <class Row>
double rise(Row row, int rows, double peak) {
    double before = 0.0, at = 0.0;
    for (int j = 0; j < rows; ++j) {
        const double here = row(j);
        if (here >= 0.5 * peak) {
            return at + (0.5 * peak - before) / (here - before) * (j + 0.5 - at);
        }
        before = here;
        at = j + 0.5;
    }
    return undefined;
}

}  // namespace

CellFreeLayer cfl_gap(const Lattice& lattice, const Suspension& cells) {
    if (cells.node_count() == 0 || !lattice.walls) return {undefined, undefined};
    const auto [low, high] = std::minmax_element(cells.y.begin(), cells.y.end());
    return {*low, lattice.ny - *high};
}

CellFreeLayer cfl_envelope(const Lattice& lattice, const Suspension& cells) {
    if (cells.node_count() == 0 || !lattice.walls) return {undefined, undefined};
    std::vector<Envelope> envelope(static_cast<std::size_t>(lattice.nx));
    for (int c = 0; c < cells.cell_count(); ++c) {
        const Outline shape = outline(cells, c);
        for (int k = 0; k < shape.size(); ++k) {
            widen(envelope, shape[k], shape[k + 1 == shape.size() ? 0 : k + 1]);
        }
    }
    double bottom = 0.0, top = 0.0;
    int crossed = 0;
    for (const Envelope& column : envelope) {
        if (column.low > column.high) continue;
        bottom += column.low;
        top += lattice.ny - column.high;
        ++crossed;
    }
    if (crossed == 0) return {undefined, undefined};
    return {bottom / crossed, top / crossed};
}

CellFreeLayer cfl_profile(std::span<const double> hematocrit) {
    const int rows = static_cast<int>(hematocrit.size());
    const double peak = rows == 0 ? 0.0 : *std::max_element(hematocrit.begin(), hematocrit.end());
    if (peak <= 0.0) return {undefined, undefined};
    return {rise([&](int j) { return hematocrit[j]; }, rows, peak),
            rise([&](int j) { return hematocrit[rows - 1 - j]; }, rows, peak)};
}

CellFreeLayer cfl_core(std::span<const double> hematocrit) {
    const int rows = static_cast<int>(hematocrit.size());
    const double peak = rows == 0 ? 0.0 : *std::max_element(hematocrit.begin(), hematocrit.end());
    if (peak <= 0.0) return {undefined, undefined};
    double bottom = 0.0, top = 0.0;
    for (int j = 0; j < rows; ++j) {
        // The middle row of an odd number lies half in either half.
        const double below = std::clamp(0.5 * rows - j, 0.0, 1.0);
        bottom += below * hematocrit[j];
        top += (1.0 - below) * hematocrit[j];
    }
    return {0.5 * rows - bottom / peak, 0.5 * rows - top / peak};
}

}  // namespace tt
