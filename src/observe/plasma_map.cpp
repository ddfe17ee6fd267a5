#include "observe/plasma_map.hpp"

#include <algorithm>
#include <cmath>

#include "membrane/outline.hpp"

namespace tt {
namespace {

int site_below(double x) { return static_cast<int>(std::floor(x - 0.5)); }

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
    std::vector<RowCrossing> crossings = row_crossings(outline);
    std::sort(crossings.begin(), crossings.end(), [](const RowCrossing& a, const RowCrossing& b) {
        return a.row != b.row ? a.row < b.row : a.x < b.x;
    });
    // From left to right every line enters and leaves: at its last crossing the winding is 0 again.
    int winding = 0;
    for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
        winding += crossings[n].turn;
        if (winding == 0) continue;
        const int last = site_below(crossings[n + 1].x);
        for (int i = site_below(crossings[n].x) + 1; i <= last; ++i)
            mark(i, crossings[n].row, taken);
    }
}

void PlasmaMap::mark(int i, int j, std::int32_t cell) {
    const int column = wrapped(i, lattice_.nx);
    const int row = lattice_.row_in_box(j);
    if (row < 0 || row >= lattice_.ny) return;
    std::int32_t& mark = marks_[static_cast<std::size_t>(row) * lattice_.nx + column];
    mark = mark == plasma || mark == cell ? cell : taken;
}

}  // namespace tt
