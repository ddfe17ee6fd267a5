#pragma once

#include <cstdint>
#include <vector>

#include "grid/lattice.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Which sites hold plasma that no membrane's smeared force disturbs: not inside a cell and not
/// within a kernel's reach (two sites along x and along y) of a node. Built anew for each
/// measurement, linear in the number of nodes and of sites covered by cells.
class PlasmaMap {
public:
    PlasmaMap(const Lattice& lattice, const Suspension& cells);

    /// Plasma beyond the reach of every membrane other than that of `cell`. Walls are no concern
    /// here.
    bool clear_of_others(int i, int j, int cell) const {
        const std::int32_t mark = marks_[static_cast<std::size_t>(j) * lattice_.nx + i];
        return mark == plasma || mark == cell;
    }

private:
    static constexpr std::int32_t plasma = -1;
    static constexpr std::int32_t taken = -2;  ///< inside a cell, or near the membranes of two

    void mark_membrane(const Outline& outline, std::int32_t cell);
    void mark_interior(const Outline& outline);
    void mark(int i, int j, std::int32_t cell);

    Lattice lattice_;
    std::vector<std::int32_t> marks_;  ///< plasma, taken, or the one cell whose membrane is near
};

}  // namespace tt
