#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "fit/polynomial.hpp"

namespace tt {

/// A parameter between two positive bounds, searched in its logarithm: 0 is the lower bound, 1 the
/// upper.
struct LogRange {
    double low = 1.0;
    double high = 2.0;

    double width() const { return std::log(high / low); }
    double value(double place) const { return low * std::exp(place * width()); }
    double place(double value) const { return std::log(value / low) / width(); }
};

/// A number to be met, with its standard uncertainty.
struct Goal {
    double value = 0.0;
    double uncertainty = 1.0;
};

/// A pair of parameters that was tried, as places in their ranges, and what was found for each
/// goal; nothing if it failed.
struct Trial {
    Vec2 at;
    std::vector<double> found;

    bool failed() const { return found.empty(); }
};

/// χ² = Σ ((found − value)/uncertainty)².
double misfit(std::span<const double> found, std::span<const Goal> goals);

/// What would be found anywhere in the ranges: a polynomial in the places for each goal, through
/// all trials that did not fail. Trials far from the goals count less, by 1/(1 + (χ² − least)/16):
/// the surface need only be right where the answer may be.
class Landscape {
public:
    /// Precondition: at least one trial that did not fail, each with a number for each goal.
    Landscape(std::span<const Trial> trials, std::vector<Goal> goals);

    std::vector<double> found(Vec2 at) const;
    /// χ² with, to the square of each goal's uncertainty, that of the surface's own error added.
    double misfit(Vec2 at) const;
    /// By how much the surface of a goal misses a trial that it has not seen (rms).
    double error(std::size_t goal) const { return surfaces_[goal].error; }
    int order(std::size_t goal) const { return surfaces_[goal].surface.order(); }

private:
    std::vector<Goal> goals_;
    std::vector<PolynomialFit> surfaces_;
};

/// Where the goals are met best and how well that is known, in places.
struct Estimate {
    Vec2 best;
    double misfit = 0.0;       ///< there
    Vec2 deviation;            ///< standard uncertainties: of exp(−χ²/2) within the ranges
    double correlation = 0.0;  ///< of the two; near ±1 in a valley of equally good pairs
    Vec2 low, high;            ///< bounds of the region with χ² ≤ least + 1

    /// Way between two places in standard uncertainties (Mahalanobis).
    double way(Vec2 from, Vec2 to) const;
};

/// The least χ² in the ranges by ever finer grids, and the moments of exp(−χ²/2) over the region
/// around it: uncertainties hold also where the region is bent, open or cut by a bound.
Estimate estimate(const Landscape& landscape);

/// The best y at this x, for a table of the valley.
Vec2 best_at(const Landscape& landscape, double x);

}  // namespace tt
