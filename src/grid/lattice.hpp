#pragma once

#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/vec2.hpp"

namespace tt {

/// n modulo count, in 0 … count − 1; without a division where it is within one period of them.
constexpr int wrapped(int n, int count) {
    if (n < 0) n += count;
    if (n >= count) n -= count;
    return n >= 0 && n < count ? n : (n % count + count) % count;
}

/// The sites of a straight channel or box and how fields lay them out in memory.
///
/// Site (i, j), 0 ≤ i < nx, 0 ≤ j < ny, stands at (i + ½, j + ½) in lattice units, so that the box
/// is [0, nx] × [0, ny] and half-way walls lie on y = 0 and y = ny. x is periodic; y is periodic or
/// walled. Around the sites lies a halo of `halo` sites on every side; filling and folding it is
/// how periodicity and walls work, so no loop ever needs a modulus.
struct Lattice {
    static constexpr int halo = 2;    ///< reach of a delta kernel beyond the outermost site
    static constexpr int margin = 8;  ///< left padding, so that every row starts on a cache line

    int nx = 0;
    int ny = 0;
    bool walls = true;  ///< walls at y = 0 and y = ny; otherwise y is periodic as well

    constexpr int pitch() const { return (margin + nx + halo + 7) / 8 * 8; }
    constexpr int rows() const { return ny + 2 * halo; }
    constexpr std::size_t size() const { return static_cast<std::size_t>(pitch()) * rows(); }
    constexpr std::size_t index(int i, int j) const {
        return static_cast<std::size_t>((j + halo) * static_cast<std::ptrdiff_t>(pitch()) + margin +
                                        i);
    }
    /// Row j brought back into the box where y is periodic; beyond a wall it stays outside.
    constexpr int row_in_box(int j) const { return walls ? j : wrapped(j, ny); }
    static constexpr Vec2 position(int i, int j) { return {i + 0.5, j + 0.5}; }
    friend constexpr bool operator==(const Lattice&, const Lattice&) = default;
};

/// [begin, end) of the rows of sites that are this thread's share …
inline std::pair<int, int> own_rows(const Lattice& lattice) { return team_share(lattice.ny); }

/// … and with them, in the outermost shares, the rows of the halo.
inline std::pair<int, int> own_rows_with_halo(const Lattice& lattice) {
    auto [begin, end] = own_rows(lattice);
    if (begin == end) return {begin, end};
    if (begin == 0) begin -= Lattice::halo;
    if (end == lattice.ny) end += Lattice::halo;
    return {begin, end};
}

}  // namespace tt
