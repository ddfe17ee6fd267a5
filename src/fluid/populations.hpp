#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "grid/d2q9.hpp"
#include "grid/field.hpp"

namespace tt {

/// Of the populations and of their collision. In fp32 rounding is relative to the deviation from
/// rest as well, and membranes, forces and velocities stay in double.
enum class Precision : std::uint8_t { fp64, fp32 };

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
/// Loops over sites get at the numbers through `visit`; `row`, `arrivals` and `departures` tell
/// where in them a row begins.
class Populations {
public:
    enum class Phase : std::uint8_t { even, odd };

    Populations() = default;
    explicit Populations(const Lattice& lattice, Precision precision = Precision::fp64);

    const Lattice& lattice() const { return lattice_; }
    Precision precision() const {
        return numbers_.index() == 0 ? Precision::fp64 : Precision::fp32;
    }
    Phase phase = Phase::even;

    /// Calls f with a pointer to all numbers, double* or float*.
    template <class F>
    decltype(auto) visit(F&& f) {
        return std::visit([&](auto& numbers) -> decltype(auto) { return f(numbers.data()); },
                          numbers_);
    }
    template <class F>
    decltype(auto) visit(F&& f) const {
        return std::visit([&](const auto& numbers) -> decltype(auto) { return f(numbers.data()); },
                          numbers_);
    }

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
    double slot(int i, int x, int y) const { return number(row(i, y) + x); }
    void set_slot(int i, int x, int y, double value) {
        visit(
            [&]<class Real>(Real* numbers) { numbers[row(i, y) + x] = static_cast<Real>(value); });
    }
    /// Population arriving at site (x, y) along c_i, less w_i. In phase odd the halo must be
    /// filled.
    double arriving(int i, int x, int y) const { return number(arrivals(i, y) + x); }

    /// Is there a wall between row j and row j + dy, dy = −1, 0 or 1?
    bool wall_between(int j, int dy) const {
        return lattice_.walls && (j + dy < 0 || j + dy >= lattice_.ny);
    }

    /// The same numbers in the same phase, halo included?
    friend bool operator==(const Populations&, const Populations&) = default;

private:
    template <class Real>
    using Numbers = std::vector<Real, CacheAligned<Real>>;

    double number(std::size_t place) const {
        return visit([&](const auto* numbers) { return double(numbers[place]); });
    }

    Lattice lattice_;
    std::size_t plane_pitch_ = 0;
    std::variant<Numbers<double>, Numbers<float>> numbers_;
};

}  // namespace tt
