#include "observe/plasma_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
    const auto corner = [&](int k) {
        return std::pair{site_below(outline.x[k]), site_below(outline.y[k])};
    };
    for (int k = 0; k < outline.size(); ++k) {
        const auto [i, j] = corner(k);
        if (k > 0 && corner(k - 1) == std::pair{i, j}) continue;  // marked for its neighbour
        const bool inside = holds_block(i - 1, j - 1);
        for (int dj = -1; dj <= 2; ++dj) {
            if (inside) {
                std::int32_t* const marks = at(i - 1, j + dj);
                for (int n = 0; n < 4; ++n) marks[n] = marked(marks[n], cell);
            } else {
                for (int di = -1; di <= 2; ++di) mark(i + di, j + dj, cell);
            }
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
    j = lattice_.row_in_box(j);
    if (j < 0 || j >= lattice_.ny) return;
    std::int32_t& mark = *at(wrapped(i, lattice_.nx), j);
    mark = marked(mark, cell);
}

bool PlasmaMap::clear_around(int i, int j, int cell) const {
    const bool inside = holds_block(i - 1, j - 1);
    for (int dj = -1; dj <= 2; ++dj) {
        const bool outer = dj == -1 || dj == 2;
        const int begin = outer ? 0 : -1, end = outer ? 2 : 3;
        if (inside) {
            const std::int32_t* const marks = at(i, j + dj);
            for (int di = begin; di < end; ++di)
                if (!clear(marks[di], cell)) return false;
            continue;
        }
        const int row = lattice_.row_in_box(j + dj);
        if (row < 0 || row >= lattice_.ny) continue;
        for (int di = begin; di < end; ++di)
            if (!clear_of_others(wrapped(i + di, lattice_.nx), row, cell)) return false;
    }
    return true;
}

}  // namespace tt
