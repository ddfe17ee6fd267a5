#include "fit/landscape.hpp"

#include <algorithm>
#include <limits>

#include "base/contracts.hpp"

namespace tt {
namespace {

constexpr int intervals = 120;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    Vec2 low{0.0, 0.0}, high{1.0, 1.0};

    Vec2 at(int i, int j) const {
        return {low.x + (high.x - low.x) * i / intervals, low.y + (high.y - low.y) * j / intervals};
    }
    double area() const { return (high.x - low.x) * (high.y - low.y); }
    void include(Vec2 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    /// Wider by one interval of `grid` on each side, within the ranges.
    Box widened(const Box& grid) const {
        const Vec2 step = (1.0 / intervals) * (grid.high - grid.low);
        return {{std::max(low.x - step.x, 0.0), std::max(low.y - step.y, 0.0)},
                {std::min(high.x + step.x, 1.0), std::min(high.y + step.y, 1.0)}};
    }
};

constexpr Box nothing{{infinity, infinity}, {-infinity, -infinity}};

/// χ² on the nodes of a grid over a box.
struct Grid {
    Box box;
    std::vector<double> misfit;
    double least = infinity;
    Vec2 best;

    Grid(const Landscape& landscape, const Box& over) : box(over) {
        for (int j = 0; j <= intervals; ++j) {
            for (int i = 0; i <= intervals; ++i) {
                misfit.push_back(landscape.misfit(box.at(i, j)));
                if (misfit.back() < least) {
                    least = misfit.back();
                    best = box.at(i, j);
                }
            }
        }
    }
    template <class F>
    void for_each(F&& f) const {
        std::size_t k = 0;
        for (int j = 0; j <= intervals; ++j)
            for (int i = 0; i <= intervals; ++i) f(box.at(i, j), misfit[k++] - least);
    }
    Box within(double excess) const {
        Box bounds = nothing;
        for_each([&](Vec2 p, double above) {
            if (above <= excess) bounds.include(p);
        });
        return bounds;
    }
};

/// The grid that just holds the region where exp(−χ²/2) is not negligible.
Grid fitting_grid(const Landscape& landscape) {
    constexpr double negligible = 14.0;
    Grid grid(landscape, Box{});
    for (int zoom = 0; zoom < 12; ++zoom) {
        const Box inner = grid.within(negligible).widened(grid.box);
        if (inner.area() > 0.6 * grid.box.area()) break;
        grid = Grid(landscape, inner);
    }
    return grid;
}

/// From the best node of a grid to the minimum, by steps that halve where none of the eight leads
/// down.
Vec2 descend(const Landscape& landscape, Vec2 at, Vec2 step) {
    double least = landscape.misfit(at);
    while (std::max(step.x, step.y) > 1e-7) {
        Vec2 next = at;
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const Vec2 p{std::clamp(at.x + i * step.x, 0.0, 1.0),
                             std::clamp(at.y + j * step.y, 0.0, 1.0)};
                const double there = landscape.misfit(p);
                if (there < least) {
                    least = there;
                    next = p;
                }
            }
        }
        if (next.x == at.x && next.y == at.y) step = 0.5 * step;
        at = next;
    }
    return at;
}

void add_moments(const Grid& grid, Estimate& result) {
    double total = 0.0;
    Vec2 mean{0.0, 0.0};
    grid.for_each([&](Vec2 p, double above) {
        const double weight = std::exp(-0.5 * above);
        total += weight;
        mean = mean + weight * p;
    });
    mean = (1.0 / total) * mean;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    grid.for_each([&](Vec2 p, double above) {
        const double weight = std::exp(-0.5 * above) / total;
        const Vec2 d = p - mean;
        xx += weight * d.x * d.x;
        xy += weight * d.x * d.y;
        yy += weight * d.y * d.y;
    });
    result.deviation = {std::sqrt(xx), std::sqrt(yy)};
    result.correlation = xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

}  // namespace

double misfit(std::span<const double> found, std::span<const Goal> goals) {
    TT_EXPECTS(found.size() == goals.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < goals.size(); ++k) {
        const double off = (found[k] - goals[k].value) / goals[k].uncertainty;
        sum += off * off;
    }
    return sum;
}

Landscape::Landscape(std::span<const Trial> trials, std::vector<Goal> goals)
    : goals_(std::move(goals)) {
    constexpr double far = 16.0;
    std::vector<Vec2> at;
    std::vector<double> weights;
    double least = infinity;
    for (const Trial& trial : trials) {
        if (trial.failed()) continue;
        at.push_back(trial.at);
        weights.push_back(tt::misfit(trial.found, goals_));
        least = std::min(least, weights.back());
    }
    TT_EXPECTS(!at.empty());
    for (double& weight : weights) weight = 1.0 / (1.0 + (weight - least) / far);
    for (std::size_t k = 0; k < goals_.size(); ++k) {
        std::vector<double> values;
        for (const Trial& trial : trials)
            if (!trial.failed()) values.push_back(trial.found[k]);
        surfaces_.push_back(fit_polynomial(at, values, weights));
    }
}

std::vector<double> Landscape::found(Vec2 at) const {
    std::vector<double> values;
    for (const PolynomialFit& fit : surfaces_) values.push_back(fit.surface(at));
    return values;
}

double Landscape::misfit(Vec2 at) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < goals_.size(); ++k) {
        const PolynomialFit& fit = surfaces_[k];
        const double off = fit.surface(at) - goals_[k].value;
        const double error = std::isfinite(fit.error) ? fit.error : 0.0;
        sum += off * off / (goals_[k].uncertainty * goals_[k].uncertainty + error * error);
    }
    return sum;
}

double Estimate::way(Vec2 from, Vec2 to) const {
    if (!(deviation.x > 0.0 && deviation.y > 0.0)) return infinity;
    const double x = (to.x - from.x) / deviation.x, y = (to.y - from.y) / deviation.y;
    const double apart = std::max(1.0 - correlation * correlation, 1e-6);
    return std::sqrt(std::max((x * x - 2.0 * correlation * x * y + y * y) / apart, 0.0));
}

Estimate estimate(const Landscape& landscape) {
    const Grid grid = fitting_grid(landscape);
    const Vec2 step = (1.0 / intervals) * (grid.box.high - grid.box.low);
    Estimate result;
    result.best = descend(landscape, grid.best, step);
    result.misfit = landscape.misfit(result.best);
    add_moments(grid, result);
    Box bounds = grid.within(1.0);
    bounds.include(result.best);
    result.low = bounds.low;
    result.high = bounds.high;
    return result;
}

Vec2 best_at(const Landscape& landscape, double x) {
    Vec2 best{x, 0.0};
    double least = infinity;
    constexpr int steps = 2000;
    for (int j = 0; j <= steps; ++j) {
        const Vec2 p{x, static_cast<double>(j) / steps};
        const double there = landscape.misfit(p);
        if (there < least) {
            least = there;
            best = p;
        }
    }
    return best;
}

}  // namespace tt
