#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/landscape.hpp"

namespace tt {

/// How long to search.
struct SearchLimits {
    int first = 12;          ///< trials that fill the ranges evenly
    int most = 40;           ///< trials in all
    double tolerance = 0.2;  ///< of the last way of the minimum, in standard uncertainties
};

/// Where a search stands after a round of trials.
struct Standpoint {
    std::vector<Trial> trials;  ///< in the order in which they were made
    std::size_t best = 0;       ///< once settled the trial at the minimum, before the best so far
    Estimate estimate;
    double way = 0.0;      ///< from the minimum to the trial nearest to it [uncertainties]
    bool settled = false;  ///< that is within the tolerance
};

/// Places that fill the unit square evenly, any number of them: multiples of the inverse powers of
/// the root of x³ = x + 1 (Roberts' generalisation of the golden ratio).
std::vector<Vec2> even_places(int count);

/// Tries pairs until the minimum of χ² stays where it was tried. Each round tries the minimum of
/// the surfaces through all trials so far and one more place with χ² ≤ least + 4, as far as
/// possible from all trials, which maps the valley where there is one; then the surfaces are made
/// anew. The pair it ends with has been tried.
class Search {
public:
    /// `given`: places to try first, beside the even ones, e.g. a pair in use.
    Search(std::vector<Goal> goals, const SearchLimits& limits,
           const std::vector<Vec2>& given = {});

    /// The places to try now; none if it has ended.
    const std::vector<Vec2>& next() const { return next_; }
    /// Takes what the trials at `next()` found. They may lie a little beside, where numbers were
    /// rounded.
    void add(std::span<const Trial> found);

    const Standpoint& standpoint() const { return now_; }
    int rounds() const { return rounds_; }
    /// The surfaces through all trials. Precondition: one did not fail.
    const Landscape& landscape() const { return *landscape_; }

private:
    std::vector<Vec2> proposals() const;

    std::vector<Goal> goals_;
    SearchLimits limits_;
    std::vector<Vec2> next_;
    Standpoint now_;
    std::optional<Landscape> landscape_;
    int rounds_ = 0;
};

}  // namespace tt
