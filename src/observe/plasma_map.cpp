#include "observe/plasma_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "membrane/outline.hpp"

namespace tt {
namespace {

int site_below(double x) { return static_cast<int>(std::floor(x - 0.5)); }

}  // namespace

void PlasmaMap::mark(const Suspension& cells) {
    const Rows rows = own_rows(lattice_);
    for (int c = 0; c < cells.cell_count(); ++c) {
        mark_membrane(outline(cells, c), c, rows);
        mark_interior(outline(cells, c), rows);
    }
}

void PlasmaMap::mark_membrane(const Outline& outline, std::int32_t cell, Rows rows) {
    const auto corner = [&](int k) {
        return std::pair{site_below(outline.x[k]), site_below(outline.y[k])};
    };
    for (int k = 0; k < outline.size(); ++k) {
        const auto [i, j] = corner(k);
        if (k > 0 && corner(k - 1) == std::pair{i, j}) continue;  // marked for its neighbour
        for (int dj = -1; dj <= 2; ++dj) {
            const int row = lattice_.row_in_box(j + dj);
            if (row < rows.first || row >= rows.second) continue;
            if (i > 0 && i + 2 < lattice_.nx) {
                std::int32_t* const marks = &marks_[place(i - 1, row)];
                for (int n = 0; n < 4; ++n) marks[n] = marked(marks[n], cell);
                continue;
            }
            for (int di = -1; di <= 2; ++di) {
                std::int32_t& mark = marks_[place(wrapped(i + di, lattice_.nx), row)];
                mark = marked(mark, cell);
            }
        }
    }
}

void PlasmaMap::mark_interior(const Outline& outline, Rows rows) {
    std::vector<RowCrossing> crossings = row_crossings(outline);
    for (RowCrossing& crossing : crossings) crossing.row = lattice_.row_in_box(crossing.row);
    std::erase_if(crossings, [&](const RowCrossing& crossing) {
        return crossing.row < rows.first || crossing.row >= rows.second;
    });
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
            marks_[place(wrapped(i, lattice_.nx), crossings[n].row)] = taken;
    }
}

bool PlasmaMap::clear_around(int i, int j, int cell) const {
    const bool inside = i > 0 && i + 2 < lattice_.nx;
    for (int dj = -1; dj <= 2; ++dj) {
        const int row = lattice_.row_in_box(j + dj);
        if (row < 0 || row >= lattice_.ny) continue;
        const bool outer = dj == -1 || dj == 2;
        for (int di = outer ? 0 : -1; di <= (outer ? 1 : 2); ++di) {
            const int column = inside ? i + di : wrapped(i + di, lattice_.nx);
            if (!clear_of_others(column, row, cell)) return false;
        }
    }
    return true;
}

}  // namespace tt
