#pragma once

#include <cstdint>
#include <vector>

#include "grid/lattice.hpp"

namespace tt {

/// A mark on every block of eight neighbouring sites of a row, one cache line of a field: where
/// membranes are near, where all sites have the same viscosity. Passes over all sites use it to
/// leave out the fields that matter only elsewhere.
class SiteBlocks {
public:
    static constexpr int width = 8;  ///< sites; rows of fields start on a block

    SiteBlocks() = default;
    explicit SiteBlocks(const Lattice& lattice)
        : per_row_((lattice.nx + width - 1) / width),
          pitch_((per_row_ + 63) / 64 * 64),
          marks_(static_cast<std::size_t>(pitch_) * lattice.ny, 0) {}

    int per_row() const { return per_row_; }
    /// From one row of marks to the next: a multiple of 64, so that loops over it have no
    /// remainder.
    int pitch() const { return pitch_; }
    /// Marks of the blocks of row j, 0 ≤ j < ny, at first 0. The last block may reach beyond nx.
    std::uint8_t* row(int j) { return marks_.data() + static_cast<std::size_t>(pitch_) * j; }
    const std::uint8_t* row(int j) const {
        return marks_.data() + static_cast<std::size_t>(pitch_) * j;
    }

private:
    int per_row_ = 0;
    int pitch_ = 0;
    std::vector<std::uint8_t> marks_;
};

}  // namespace tt
