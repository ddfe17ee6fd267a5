#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/d2q9.hpp"
#include "grid/field.hpp"

namespace tt {

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
class Populations {
public:
    enum class Phase : std::uint8_t { even, odd };

    Populations() = default;
    explicit Populations(const Lattice& lattice);
    Populations(const Populations& other);
    Populations& operator=(const Populations& other);
    Populations(Populations&&) noexcept = default;
    Populations& operator=(Populations&&) noexcept = default;

    const Lattice& lattice() const { return lattice_; }
    Phase phase = Phase::even;

    /// Slot `i`, row `j`: pointer to site (0, j).
    double* row(int i, int j) { return plane_[i] + lattice_.index(0, j); }
    const double* row(int i, int j) const { return plane_[i] + lattice_.index(0, j); }
    double& slot(int i, int x, int y) { return plane_[i][lattice_.index(x, y)]; }
    double slot(int i, int x, int y) const { return plane_[i][lattice_.index(x, y)]; }

    /// arrivals(i, j)[x] is the population arriving at site (x, j) along c_i, in either phase, and
    /// the place where the pass leaves the one that departs from (x, j) along opposite(i). In phase
    /// odd it may lie in the halo.
    double* arrivals(int i, int j) { return arrival_row(i, j); }
    const double* arrivals(int i, int j) const { return arrival_row(i, j); }
    /// departures(i, j)[x] is where the pass leaves the population that departs from site (x, j)
    /// along c_i.
    double* departures(int i, int j) { return arrivals(d2q9::opposite[i], j); }

    /// Population arriving at site (x, y) along c_i, less w_i. In phase odd the halo must be
    /// filled.
    double arriving(int i, int x, int y) const { return arrivals(i, y)[x]; }

    /// Is there a wall between row j and row j + dy, dy = −1, 0 or 1?
    bool wall_between(int j, int dy) const {
        return lattice_.walls && (j + dy < 0 || j + dy >= lattice_.ny);
    }

    /// The raw storage, for checkpoints and hashes.
    std::vector<double, CacheAligned<double>>& storage() { return storage_; }
    const std::vector<double, CacheAligned<double>>& storage() const { return storage_; }

private:
    bool found_at_home(int i, int j) const {
        return phase == Phase::even || wall_between(j, -d2q9::cy[i]);
    }
    double* arrival_row(int i, int j) const {
        if (found_at_home(i, j)) return plane_[i] + lattice_.index(0, j);
        return plane_[d2q9::opposite[i]] + lattice_.index(-d2q9::cx[i], j - d2q9::cy[i]);
    }
    void place_planes();

    Lattice lattice_;
    std::vector<double, CacheAligned<double>> storage_;
    std::array<double*, d2q9::count> plane_{};
};

}  // namespace tt
