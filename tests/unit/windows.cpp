#include "observe/windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"

namespace tt {
namespace {

/// x_t = ρ x_{t−1} + uniform noise: correlation time about 1/(1 − ρ).
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

TEST(Windows, start_at_half_of_the_run_unless_the_case_says_otherwise) {
    EXPECT_EQ(window_start(Time{0.08}, std::nullopt).si, 0.04);
    EXPECT_EQ(window_start(Time{0.08}, Time{0.01}).si, 0.01);
}

TEST(Windows, mean_and_scatter_of_a_few_numbers) {
    const std::vector<double> samples{1, 2, 3, 6};
    const WindowStatistics s = window_statistics(samples);
    EXPECT_EQ(s.samples, 4);
    EXPECT_DOUBLE_EQ(s.mean, 3.0);
    EXPECT_DOUBLE_EQ(s.sd, std::sqrt((4 + 1 + 0 + 9) / 3.0));
    EXPECT_TRUE(std::isnan(s.standard_error)) << "too few samples for ten batches";
    EXPECT_TRUE(std::isnan(window_statistics({}).mean));
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

TEST(Windows, cell_statistics_separate_unlike_cells_from_unsteady_ones) {
    const std::vector<double> unlike{1, 3, 1, 3, 1, 3};  // two cells, three times
    const CellStatistics a = cell_statistics(unlike, 2);
    EXPECT_EQ(a.samples, 3);
    EXPECT_DOUBLE_EQ(a.mean, 2.0);
    EXPECT_DOUBLE_EQ(a.sd_cells, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(a.sd_time, 0.0);
    EXPECT_DOUBLE_EQ(a.sd_all, std::sqrt(6.0 / 5.0));
    const std::vector<double> unsteady{1, 1, 2, 2, 3, 3};
    const CellStatistics b = cell_statistics(unsteady, 2);
    EXPECT_DOUBLE_EQ(b.sd_cells, 0.0);
    EXPECT_DOUBLE_EQ(b.sd_time, 1.0);
}

TEST(Windows, tank_treading_period_is_that_of_the_mean_rate_whatever_its_sense) {
    EXPECT_DOUBLE_EQ(tank_treading_kT(Rate{100.0}, Rate{-50.0}), 4 * 3.14159265358979323846);
}

}  // namespace
}  // namespace tt
