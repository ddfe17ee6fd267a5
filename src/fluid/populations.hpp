#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/d2q9.hpp"
#include "grid/field.hpp"

namespace tt {

/// Where the populations lie, see below.
enum class Phase : std::uint8_t { even, odd };

/// The nine populations per site, stored as f_i − w_i (so that rounding is relative to the
/// deviation from rest, not to ρ = 1), one plane per velocity, streamed in place by the AA pattern
/// (Bailey et al. 2009):
///
/// - phase even: the population arriving at site x along c_i lies in slot i of x itself;
/// - phase odd: it lies in slot opposite(i) of site x − c_i, where the even pass left it.
///
/// In both phases a pass reads what arrives along c_i and leaves what departs along the *opposite*
/// direction in that same place (`arrivals`), and the phases take turns. Every slot is read and
/// written by exactly one site, so the update is in place, in any order, on any number of threads.
///
/// Half-way bounce-back needs no pass of its own: where x − c_i lies beyond a wall, what departs
/// into the wall is left in slot i of the site itself in both phases, where the same site finds it
/// coming back.
///
/// `row`, `arrivals` and `departures` tell where in the numbers of `data` a row begins.
template <class Real = double>
class Populations {
public:
    Populations() = default;
    explicit Populations(const Lattice& lattice);

    const Lattice& lattice() const { return lattice_; }
    Phase phase = Phase::even;

    Real* data() { return numbers_.data(); }
    const Real* data() const { return numbers_.data(); }

    /// Place of slot `i` of site (0, j); those of the row follow.
    std::size_t row(int i, int j) const { return i * plane_pitch_ + lattice_.index(0, j); }
    /// Place of the population arriving at site (0, j) along c_i, in either phase, and where the
    /// pass leaves the one that departs from there along opposite(i); those of the row follow. In
    /// phase odd it may lie in the halo.
    std::size_t arrivals(int i, int j) const {
        const bool found_at_home = phase == Phase::even || wall_between(j, -d2q9::cy[i]);
        if (found_at_home) return row(i, j);
        return d2q9::opposite[i] * plane_pitch_ + lattice_.index(-d2q9::cx[i], j - d2q9::cy[i]);
    }
    /// Place where the pass leaves the population that departs from site (0, j) along c_i.
    std::size_t departures(int i, int j) const { return arrivals(d2q9::opposite[i], j); }

    /// Population in slot i of site (x, y), less w_i. One at a time: for tests and set-up.
    double slot(int i, int x, int y) const { return numbers_[row(i, y) + x]; }
    void set_slot(int i, int x, int y, double value) {
        numbers_[row(i, y) + x] = static_cast<Real>(value);
    }
    /// Population arriving at site (x, y) along c_i, less w_i. In phase odd the halo must be
    /// filled.
    double arriving(int i, int x, int y) const { return numbers_[arrivals(i, y) + x]; }

    /// Is there a wall between row j and row j + dy, dy = −1, 0 or 1?
    bool wall_between(int j, int dy) const {
        return lattice_.walls && (j + dy < 0 || j + dy >= lattice_.ny);
    }

    /// The same numbers in the same phase, halo included?
    friend bool operator==(const Populations&, const Populations&) = default;

private:
    Lattice lattice_;
    std::size_t plane_pitch_ = 0;
    std::vector<Real, CacheAligned<Real>> numbers_;
};

}  // namespace tt
