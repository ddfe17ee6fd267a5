#include "fit/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tt {
namespace {

double nearest(Vec2 place, std::span<const Trial> trials, std::span<const Vec2> others) {
    double least = std::numeric_limits<double>::infinity();
    for (const Trial& trial : trials) least = std::min(least, norm(trial.at - place));
    for (const Vec2 other : others) least = std::min(least, norm(other - place));
    return least;
}

/// Where trials failed, others near by are likely to fail as well.
bool likely_to_fail(Vec2 place, std::span<const Trial> trials, double near) {
    return std::any_of(trials.begin(), trials.end(), [&](const Trial& trial) {
        return trial.failed() && norm(trial.at - place) < near;
    });
}

constexpr int steps = 40;

/// The nodes of a grid over a box.
template <class F>
void for_each_place(Vec2 low, Vec2 high, F&& f) {
    for (int j = 0; j <= steps; ++j)
        for (int i = 0; i <= steps; ++i)
            f(Vec2{low.x + (high.x - low.x) * i / steps, low.y + (high.y - low.y) * j / steps});
}

/// The place with the least χ² that is not near a failed trial.
std::optional<Vec2> best_beside_failures(const Landscape& landscape,
                                         std::span<const Trial> trials) {
    constexpr double near = 0.12;
    std::optional<Vec2> best;
    double least = std::numeric_limits<double>::infinity();
    for_each_place({0.0, 0.0}, {1.0, 1.0}, [&](Vec2 p) {
        const double there = landscape.misfit(p);
        if (there >= least || likely_to_fail(p, trials, near)) return;
        least = there;
        best = p;
    });
    return best;
}

/// The place with χ² ≤ least + 4 that is farthest from all trials, unless one of them is near.
std::optional<Vec2> explorer(const Landscape& landscape, const Estimate& estimate,
                             std::span<const Trial> trials, std::span<const Vec2> others) {
    constexpr double excess = 4.0, near = 0.15, near_failed = 0.06;
    const Vec2 size = estimate.high - estimate.low;
    const auto inside = [](Vec2 p) {
        return Vec2{std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)};
    };
    std::optional<Vec2> farthest;
    double most = near * norm(size);
    for_each_place(inside(estimate.low - size), inside(estimate.high + size), [&](Vec2 p) {
        if (landscape.misfit(p) > estimate.misfit + excess) return;
        const double distance = nearest(p, trials, others);
        if (distance <= most || likely_to_fail(p, trials, near_failed)) return;
        most = distance;
        farthest = p;
    });
    return farthest;
}

std::size_t best_of(std::span<const Trial> trials, std::span<const Goal> goals) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < trials.size(); ++k) {
        const double here = trials[k].failed() ? least : misfit(trials[k].found, goals);
        if (here < least) {
            least = here;
            best = k;
        }
    }
    return best;
}

}  // namespace

std::vector<Vec2> even_places(int count) {
    constexpr double root = 1.32471795724474602596;
    std::vector<Vec2> places;
    for (int k = 1; k <= count; ++k) {
        const double x = 0.5 + k / root, y = 0.5 + k / (root * root);
        places.push_back({x - std::floor(x), y - std::floor(y)});
    }
    return places;
}

Search::Search(std::vector<Goal> goals, const SearchLimits& limits, const std::vector<Vec2>& given)
    : goals_(std::move(goals)), limits_(limits), next_(given) {
    const int more = std::max(limits_.first - static_cast<int>(given.size()), 0);
    for (const Vec2 place : even_places(more)) next_.push_back(place);
}

std::vector<Vec2> Search::proposals() const {
    std::vector<Vec2> places;
    constexpr double same = 1e-3, near_failed = 0.06;
    std::optional<Vec2> best = now_.estimate.best;
    if (likely_to_fail(*best, now_.trials, near_failed))
        best = best_beside_failures(*landscape_, now_.trials);
    if (best && nearest(*best, now_.trials, {}) > same) places.push_back(*best);
    if (const auto place = explorer(*landscape_, now_.estimate, now_.trials, places))
        places.push_back(*place);
    const auto room =
        static_cast<std::size_t>(std::max(limits_.most - static_cast<int>(now_.trials.size()), 0));
    if (places.size() > room) places.resize(room);
    return places;
}

void Search::add(std::span<const Trial> found) {
    now_.trials.insert(now_.trials.end(), found.begin(), found.end());
    next_.clear();
    now_.best = best_of(now_.trials, goals_);
    if (now_.trials.empty() || now_.trials[now_.best].failed()) return;
    landscape_.emplace(now_.trials, goals_);
    now_.estimate = estimate(*landscape_);
    now_.way = std::numeric_limits<double>::infinity();
    std::size_t nearest_trial = now_.best;
    for (std::size_t k = 0; k < now_.trials.size(); ++k) {
        const double way = now_.estimate.way(now_.trials[k].at, now_.estimate.best);
        if (now_.trials[k].failed() || way >= now_.way) continue;
        now_.way = way;
        nearest_trial = k;
    }
    // The even places alone settle nothing, however near to the minimum one of them lies.
    now_.settled = rounds_ > 0 && now_.way < limits_.tolerance;
    if (now_.settled) now_.best = nearest_trial;
    ++rounds_;
    if (!now_.settled) next_ = proposals();
}

}  // namespace tt
