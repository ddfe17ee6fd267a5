#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/d2q9.hpp"
#include "grid/field.hpp"

namespace tt {

/// The nine populations per site, stored as f_i − w_i (so that rounding is relative to the deviation from rest,
/// not to ρ = 1), one plane per velocity, streamed in place by the AA pattern (Bailey et al. 2009):
///
/// - phase even: slot i of a site holds the population that *arrives* there along c_i. The pass collides and
///   leaves the result for direction i in slot opposite(i) of the same site.
/// - phase odd: the population arriving at x along c_i lies in slot opposite(i) of site x − c_i. The pass collides
///   and writes direction i to slot i of site x + c_i, which restores the even layout.
///
/// In both phases every slot of every site is read and written by exactly one site, so the update is in place,
/// in any order, on any number of threads. Before an odd pass the halo must be filled, after it folded.
class Populations {
public:
    enum class Phase : std::uint8_t { even, odd };

    Populations() = default;
    explicit Populations(const Lattice& lattice);

    const Lattice& lattice() const { return lattice_; }
    Phase phase = Phase::even;

    /// Slot `i`, row `j`: pointer to site (0, j).
    double* row(int i, int j) { return plane_[i] + lattice_.index(0, j); }
    const double* row(int i, int j) const { return plane_[i] + lattice_.index(0, j); }
    double& slot(int i, int x, int y) { return plane_[i][lattice_.index(x, y)]; }
    double slot(int i, int x, int y) const { return plane_[i][lattice_.index(x, y)]; }

    /// Population arriving at site (x, y) along c_i, whatever the phase, less w_i. In phase odd the halo must be filled.
    double arriving(int i, int x, int y) const {
        if (phase == Phase::even) return slot(i, x, y);
        return slot(d2q9::opposite[i], x - d2q9::cx[i], y - d2q9::cy[i]);
    }

    Populations(const Populations& other);
    Populations& operator=(const Populations& other);
    Populations(Populations&&) noexcept = default;
    Populations& operator=(Populations&&) noexcept = default;

    /// The raw storage, for checkpoints and hashes.
    std::vector<double, CacheAligned<double>>& storage() { return storage_; }
    const std::vector<double, CacheAligned<double>>& storage() const { return storage_; }

private:
    void place_planes();

    Lattice lattice_;
    std::vector<double, CacheAligned<double>> storage_;
    std::array<double*, d2q9::count> plane_{};
};

}  // namespace tt
