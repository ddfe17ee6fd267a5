#pragma once

#include <cstdint>
#include <vector>

#include "grid/lattice.hpp"

namespace tt {

/// A mark on every block of eight neighbouring sites of a row, one cache line of a field: where
/// membranes are near. Passes over all sites use it to leave out the fields that matter only there.
class SiteBlocks {
public:
    static constexpr int width = 8;  ///< sites; rows of fields start on a block

    SiteBlocks() = default;
    explicit SiteBlocks(const Lattice& lattice)
        : per_row_((lattice.nx + width - 1) / width),
          marks_(static_cast<std::size_t>(per_row_) * lattice.ny, 0) {}

    int per_row() const { return per_row_; }
    /// Marks of the blocks of row j, 0 ≤ j < ny: 1 or 0. The last block may reach beyond nx.
    std::uint8_t* row(int j) { return marks_.data() + static_cast<std::size_t>(per_row_) * j; }
    const std::uint8_t* row(int j) const {
        return marks_.data() + static_cast<std::size_t>(per_row_) * j;
    }

private:
    int per_row_ = 0;
    std::vector<std::uint8_t> marks_;
};

}  // namespace tt
