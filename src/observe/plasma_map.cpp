#include "observe/plasma_map.hpp"

#include <algorithm>
#include <cmath>

namespace tt {
namespace {

int site_below(double x) { return static_cast<int>(std::floor(x - 0.5)); }

/// Where an outline crosses the line y = height, from left to right, and which way.
struct Crossing {
    double x;
    int turn;  ///< +1 upwards
};
std::vector<Crossing> crossings(const Outline& outline, double height) {
    std::vector<Crossing> found;
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[k + 1 == outline.size() ? 0 : k + 1];
        if ((a.y >= height) == (b.y >= height)) continue;
        const double x = a.x + (height - a.y) / (b.y - a.y) * (b.x - a.x);
        found.push_back({x, b.y > a.y ? 1 : -1});
    }
    std::sort(found.begin(), found.end(), [](Crossing a, Crossing b) { return a.x < b.x; });
    return found;
}

}  // namespace

PlasmaMap::PlasmaMap(const Lattice& lattice, const Suspension& cells)
    : lattice_(lattice), marks_(static_cast<std::size_t>(lattice.nx) * lattice.ny, plasma) {
    for (int c = 0; c < cells.cell_count(); ++c) {
        mark_membrane(outline(cells, c), c);
        mark_interior(outline(cells, c));
    }
}

void PlasmaMap::mark_membrane(const Outline& outline, std::int32_t cell) {
    for (int k = 0; k < outline.size(); ++k) {
        const int i = site_below(outline.x[k]), j = site_below(outline.y[k]);
        for (int dj = -1; dj <= 2; ++dj) {
            for (int di = -1; di <= 2; ++di) mark(i + di, j + dj, cell);
        }
    }
}

void PlasmaMap::mark_interior(const Outline& outline) {
    const auto [low, high] = std::minmax_element(outline.y.begin(), outline.y.end());
    for (int j = site_below(*low); j <= site_below(*high); ++j) {
        int winding = 0;
        const std::vector<Crossing> row = crossings(outline, j + 0.5);
        for (std::size_t n = 0; n + 1 < row.size(); ++n) {
            winding += row[n].turn;
            if (winding == 0) continue;
            const int last = site_below(row[n + 1].x);
            for (int i = site_below(row[n].x) + 1; i <= last; ++i) mark(i, j, taken);
        }
    }
}

void PlasmaMap::mark(int i, int j, std::int32_t cell) {
    const int column = wrapped(i, lattice_.nx);
    const int row = lattice_.walls ? j : wrapped(j, lattice_.ny);
    if (row < 0 || row >= lattice_.ny) return;
    std::int32_t& mark = marks_[static_cast<std::size_t>(row) * lattice_.nx + column];
    mark = mark == plasma || mark == cell ? cell : taken;
}

}  // namespace tt
