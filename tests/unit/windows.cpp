#include "observe/windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"

namespace tt {
namespace {

/// x_t = ρ x_{t−1} + uniform noise, correlated as ρ^k.
std::vector<double> correlated(std::uint64_t seed, double rho, int count) {
    Random random(seed);
    std::vector<double> samples;
    double x = 0.0;
    for (int t = 0; t < count; ++t) {
        x = rho * x + random.uniform(-1.0, 1.0);
        samples.push_back(5.0 + x);
    }
    return samples;
}

TEST(Windows, mean_and_scatter_of_a_few_numbers) {
    const std::vector<double> samples{1, 2, 3, 6};
    const WindowStatistics s = window_statistics(samples);
    EXPECT_EQ(s.samples, 4);
    EXPECT_DOUBLE_EQ(s.mean, 3.0);
    EXPECT_DOUBLE_EQ(s.sd, std::sqrt((4 + 1 + 0 + 9) / 3.0));
    EXPECT_DOUBLE_EQ(s.smallest, 1.0);
    EXPECT_DOUBLE_EQ(s.largest, 6.0);
    EXPECT_TRUE(std::isnan(s.standard_error)) << "too few samples for ten batches";
    EXPECT_TRUE(std::isnan(window_statistics({}).mean));
}

TEST(Windows, samples_that_are_not_defined_are_left_out) {
    const std::vector<double> samples{1, std::nan(""), 3};
    const WindowStatistics s = window_statistics(samples);
    EXPECT_EQ(s.samples, 2);
    EXPECT_DOUBLE_EQ(s.mean, 2.0);
}

TEST(Windows, standard_error_is_honest_about_correlated_samples) {
    // Over 200 seeds the scatter of the mean must be what the standard error says; sd/√n says 4.4
    // times less.
    double squares = 0.0, errors = 0.0, naive = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const WindowStatistics s = window_statistics(correlated(seed, 0.9, 2000));
        squares += (s.mean - 5.0) * (s.mean - 5.0);
        errors += s.standard_error * s.standard_error;
        naive += s.sd * s.sd / 2000;
    }
    EXPECT_NEAR(std::sqrt(errors / squares), 1.0, 0.2);
    EXPECT_LT(std::sqrt(naive / squares), 0.3);
}

TEST(Windows, correlation_time_is_the_sum_of_the_correlations) {
    // ½ + Σ ρ^k = ½ (1 + ρ)/(1 − ρ): 9.5 at ρ = 0.9, whatever the number of samples.
    for (const int count : {2000, 40000}) {
        double time = 0.0, worth = 0.0;
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const WindowStatistics s = window_statistics(correlated(seed, 0.9, count));
            time += s.correlation_time / 50;
            worth += s.effective_samples / 50;
        }
        EXPECT_NEAR(time, 9.5, 0.1 * 9.5) << count;
        EXPECT_NEAR(worth, count / 19.0, 0.2 * count / 19.0) << count;
    }
    EXPECT_NEAR(window_statistics(correlated(1, 0.0, 2000)).correlation_time, 0.5, 0.1);
}

TEST(Windows, a_drift_lasts_less_than_ten_correlation_times_and_a_constant_does_not) {
    std::vector<double> drift, constant(100, 3.0), settling;
    for (int t = 0; t < 100; ++t) {
        drift.push_back(1.0 + 0.01 * t);
        settling.push_back(1.0 - std::exp(-t / 50.0));
    }
    EXPECT_GT(10.0 * window_statistics(drift).correlation_time, 100.0);
    EXPECT_GT(10.0 * window_statistics(settling).correlation_time, 100.0);
    EXPECT_LT(10.0 * window_statistics(constant).correlation_time, 100.0);
    EXPECT_EQ(window_statistics(constant).standard_error, 0.0);
}

}  // namespace
}  // namespace tt
