#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/lattice.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Which sites hold plasma that no membrane's smeared force disturbs: not inside a cell and not
/// within a kernel's reach (two sites along x and along y) of a node. Built anew for each
/// measurement, linear in the number of nodes and of sites covered by cells.
class PlasmaMap {
public:
    /// Nothing but plasma.
    explicit PlasmaMap(const Lattice& lattice)
        : lattice_(lattice), marks_(static_cast<std::size_t>(lattice.nx) * lattice.ny, plasma) {}
    PlasmaMap(const Lattice& lattice, const Suspension& cells) : PlasmaMap(lattice) { mark(cells); }

    /// Marks what is not. Team function, by rows of sites.
    void mark(const Suspension& cells);

    /// Plasma beyond the reach of every membrane other than that of `cell`. Walls are no concern
    /// here.
    bool clear_of_others(int i, int j, int cell) const { return clear(marks_[place(i, j)], cell); }

    /// The same of all sites that FlowView::at reads where (i, j) is the last site before a
    /// position along x and along y: the 4 × 4 block from (i − 1, j − 1) but for its corners. Any i
    /// and j; what lies beyond a wall is not asked.
    bool clear_around(int i, int j, int cell) const;

private:
    static constexpr std::int32_t plasma = -1;
    static constexpr std::int32_t taken = -2;  ///< inside a cell, or near the membranes of two

    static bool clear(std::int32_t mark, int cell) { return mark == plasma || mark == cell; }
    std::size_t place(int i, int j) const { return static_cast<std::size_t>(j) * lattice_.nx + i; }

    using Rows = std::pair<int, int>;  ///< [first, second)
    void mark_membrane(const Outline& outline, std::int32_t cell, Rows rows);
    void mark_interior(const Outline& outline, Rows rows);
    static std::int32_t marked(std::int32_t mark, std::int32_t cell) {
        return clear(mark, cell) ? cell : taken;
    }

    Lattice lattice_;
    std::vector<std::int32_t> marks_;  ///< plasma, taken, or the one cell whose membrane is near
};

}  // namespace tt
