#include "fit/search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/random.hpp"

namespace {

using tt::Goal;
using tt::Trial;
using tt::Vec2;
using Model = std::function<std::vector<double>(double D, double beta)>;

constexpr tt::LogRange D_range{0.1, 2.0}, beta_range{5.0, 30.0};

/// Strain that saturates as α = 1 + D (e^{β ε} − 1) does: ε with ε α(ε) = load.
double strain(double D, double beta, double load) {
    double low = 0.0, high = load;
    for (int k = 0; k < 80; ++k) {
        const double middle = 0.5 * (low + high);
        const double tension = middle * (1.0 + D * std::expm1(beta * middle));
        (tension < load ? low : high) = middle;
    }
    return low;
}

std::vector<double> two_loads(double D, double beta) {
    return {strain(D, beta, 0.1), strain(D, beta, 0.6)};
}

tt::Search searched(const Model& model, const std::vector<Goal>& goals,
                    const tt::SearchLimits& limits = {}) {
    tt::Search search(goals, limits);
    while (!search.next().empty()) {
        std::vector<Trial> trials;
        for (const Vec2 at : search.next())
            trials.push_back({at, model(D_range.value(at.x), beta_range.value(at.y))});
        search.add(trials);
    }
    return search;
}

std::vector<Goal> goals_at(const Model& model, double D, double beta, double uncertainty) {
    std::vector<Goal> goals;
    for (const double value : model(D, beta)) goals.push_back({value, uncertainty});
    return goals;
}

TEST(Polynomial, of_third_order_is_found_exactly_and_noise_does_not_raise_the_order) {
    std::vector<Vec2> at = tt::even_places(20);
    std::vector<double> cubic, noisy, weights(at.size(), 1.0);
    tt::Random random(5);
    for (const Vec2 p : at) {
        cubic.push_back(1.0 + p.x - p.x * p.y * p.y + 3.0 * p.y * p.y * p.y);
        noisy.push_back(2.0 + p.x + random.uniform(-0.3, 0.3));
    }
    const tt::PolynomialFit fit = tt::fit_polynomial(at, cubic, weights);
    EXPECT_EQ(fit.surface.order(), 3);
    EXPECT_NEAR(fit.surface({0.3, 0.9}), 1.0 + 0.3 - 0.3 * 0.81 + 3.0 * 0.729, 1e-10);
    EXPECT_LT(fit.error, 1e-10);
    const tt::PolynomialFit plain = tt::fit_polynomial(at, noisy, weights);
    EXPECT_LE(plain.surface.order(), 1);
    EXPECT_NEAR(plain.error, 0.3 / std::sqrt(3.0), 0.08);
}

TEST(Polynomial, of_one_value_is_that_value) {
    const tt::PolynomialFit fit =
        tt::fit_polynomial(std::vector<Vec2>{{0.2, 0.7}}, std::vector<double>{4.0}, {{1.0}});
    EXPECT_EQ(fit.surface({0.9, 0.1}), 4.0);
}

TEST(Search, finds_a_known_pair_within_its_uncertainty) {
    for (const auto& [D, beta] : std::vector<std::pair<double, double>>{{0.5, 15.0}, {0.2, 22.0}}) {
        const tt::Search search = searched(two_loads, goals_at(two_loads, D, beta, 2e-4));
        const tt::Standpoint& now = search.standpoint();
        EXPECT_TRUE(now.settled);
        const Vec2 truth{D_range.place(D), beta_range.place(beta)};
        EXPECT_LT(now.estimate.way(truth, now.estimate.best), 2.5);
        EXPECT_LT(std::abs(now.estimate.best.x - truth.x), 3.0 * now.estimate.deviation.x);
        EXPECT_LT(std::abs(now.estimate.best.y - truth.y), 3.0 * now.estimate.deviation.y);
        EXPECT_LT(now.estimate.deviation.y, 0.1) << "an uncertainty that says something";
        EXPECT_LT(tt::misfit(now.trials[now.best].found, goals_at(two_loads, D, beta, 2e-4)), 8.0);
    }
}

TEST(Search, uncertainties_of_a_linear_model_are_those_of_least_squares) {
    // f = (x + y, x − 2 y) with uncertainties 0.02 and 0.03 in places: exact covariance.
    const Model linear = [](double D, double beta) {
        const double x = D_range.place(D), y = beta_range.place(beta);
        return std::vector<double>{x + y, x - 2.0 * y};
    };
    const std::vector<Goal> goals{{1.0, 0.02}, {-0.5, 0.03}};
    const tt::Estimate e = searched(linear, goals).standpoint().estimate;
    // (JᵀJ)⁻¹ with rows divided by the uncertainties: x = (2 f + g)/3, y = (f − g)/3.
    const double xx = (4.0 * 4e-4 + 9e-4) / 9.0, yy = (4e-4 + 9e-4) / 9.0;
    const double xy = (2.0 * 4e-4 - 9e-4) / 9.0;
    EXPECT_NEAR(e.best.x, 0.5, 1e-5);
    EXPECT_NEAR(e.best.y, 0.5, 1e-5);
    EXPECT_NEAR(e.deviation.x, std::sqrt(xx), 0.01 * std::sqrt(xx));
    EXPECT_NEAR(e.deviation.y, std::sqrt(yy), 0.01 * std::sqrt(yy));
    EXPECT_NEAR(e.correlation, xy / std::sqrt(xx * yy), 0.01);
    EXPECT_NEAR(e.high.x - e.best.x, std::sqrt(xx), 0.1 * std::sqrt(xx));
    EXPECT_LT(e.misfit, 1e-6);
}

TEST(Search, one_goal_gives_a_valley_with_correlation_near_minus_one) {
    const Model one = [](double D, double beta) {
        return std::vector<double>{strain(D, beta, 0.3)};
    };
    const tt::Search search = searched(one, goals_at(one, 0.5, 15.0, 1e-3));
    const tt::Estimate& e = search.standpoint().estimate;
    EXPECT_LT(e.correlation, -0.9);
    EXPECT_GT(e.deviation.x, 0.2) << "nothing tells D apart from beta";
    EXPECT_LT(e.low.x, 0.1);
    EXPECT_GT(e.high.x, 0.9);
    for (const double x : {0.2, 0.5, 0.8}) {
        const Vec2 p = tt::best_at(search.landscape(), x);
        EXPECT_NEAR(strain(D_range.value(p.x), beta_range.value(p.y), 0.3), strain(0.5, 15.0, 0.3),
                    2e-3);
    }
}

TEST(Search, noise_of_the_runs_widens_the_uncertainty) {
    tt::Random random(3);
    const Model noisy = [&](double D, double beta) {
        std::vector<double> found = two_loads(D, beta);
        for (double& value : found) value += random.uniform(-0.003, 0.003);
        return found;
    };
    const auto goals = goals_at(two_loads, 0.5, 15.0, 2e-4);
    const tt::Search search = searched(noisy, goals);
    const tt::Estimate& e = search.standpoint().estimate;
    const tt::Estimate sharp = searched(two_loads, goals).standpoint().estimate;
    EXPECT_GT(e.deviation.x, 2.0 * sharp.deviation.x);
    EXPECT_LT(e.way({D_range.place(0.5), beta_range.place(15.0)}, e.best), 3.0);
    EXPECT_NEAR(search.landscape().error(0), 0.003 / std::sqrt(3.0), 0.0012);
}

TEST(Search, goes_on_around_pairs_that_fail) {
    const Model fragile = [](double D, double beta) {
        return D * beta > 20.0 ? std::vector<double>{} : two_loads(D, beta);
    };
    const tt::Search search = searched(fragile, goals_at(two_loads, 0.5, 15.0, 1e-3));
    const tt::Standpoint& now = search.standpoint();
    EXPECT_TRUE(now.settled);
    EXPECT_FALSE(now.trials[now.best].failed());
    EXPECT_LT(now.estimate.way({D_range.place(0.5), beta_range.place(15.0)}, now.estimate.best),
              2.0);
}

TEST(Search, ends_where_everything_fails_and_at_its_limit) {
    const Model broken = [](double, double) { return std::vector<double>{}; };
    const tt::Search nothing = searched(broken, {{1.0, 0.1}});
    EXPECT_EQ(nothing.standpoint().trials.size(), 12u);
    EXPECT_FALSE(nothing.standpoint().settled);
    tt::SearchLimits limits;
    limits.first = 6;
    limits.most = 9;
    limits.tolerance = 1e-9;
    const tt::Search cut = searched(two_loads, goals_at(two_loads, 0.5, 15.0, 1e-3), limits);
    EXPECT_EQ(cut.standpoint().trials.size(), 9u);
    EXPECT_FALSE(cut.standpoint().settled);
}

}  // namespace
