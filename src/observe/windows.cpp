#include "observe/windows.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/undefined.hpp"

namespace tt {
namespace {

constexpr std::size_t batches = 10;
/// A window of more samples is first averaged over blocks: its lags would take a time of n².
constexpr std::size_t most_lags = 2000;

double mean_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return values.empty() ? undefined : sum / static_cast<double>(values.size());
}

double sd_of(std::span<const double> values) {
    if (values.size() < 2) return undefined;
    const double mean = mean_of(values);
    double squares = 0.0;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

/// Means of successive blocks of `length` samples, the last ones of the window.
std::vector<double> block_means(std::span<const double> samples, std::size_t length) {
    const auto used = samples.last(samples.size() / length * length);
    std::vector<double> means;
    for (std::size_t begin = 0; begin < used.size(); begin += length)
        means.push_back(mean_of(used.subspan(begin, length)));
    return means;
}

double standard_error(std::span<const double> samples) {
    return sd_of(block_means(samples, samples.size() / batches)) /
           std::sqrt(static_cast<double>(batches));
}

/// In samples; ½ where nothing scatters.
double correlation_time_of_all(std::span<const double> samples) {
    const double mean = mean_of(samples);
    const auto covariance = [&](std::size_t lag) {
        double sum = 0.0;
        for (std::size_t k = lag; k < samples.size(); ++k)
            sum += (samples[k] - mean) * (samples[k - lag] - mean);
        return sum;
    };
    const double variance = covariance(0);
    double time = 0.5;
    for (std::size_t lag = 1; variance > 0.0 && lag < samples.size(); ++lag) {
        time = std::max(0.5, time + covariance(lag) / variance);
        if (static_cast<double>(lag) >= 5.0 * time) break;
    }
    return time;
}

/// The same of a long window, by block means: their variance times their correlation time is that
/// of the samples, both per unit of time.
double correlation_time(std::span<const double> samples) {
    const std::size_t length = (samples.size() + most_lags - 1) / most_lags;
    const std::vector<double> means = block_means(samples, length);
    const double ratio = sd_of(means) / sd_of(samples);
    const double time = static_cast<double>(length) * correlation_time_of_all(means);
    return std::isfinite(ratio) ? std::max(0.5, ratio * ratio * time) : time;
}

}  // namespace

WindowStatistics window_statistics(std::span<const double> samples) {
    std::vector<double> known;
    for (const double v : samples)
        if (std::isfinite(v)) known.push_back(v);
    WindowStatistics s;
    s.samples = static_cast<std::int64_t>(known.size());
    s.mean = mean_of(known);
    s.sd = sd_of(known);
    s.smallest = known.empty() ? undefined : *std::min_element(known.begin(), known.end());
    s.largest = known.empty() ? undefined : *std::max_element(known.begin(), known.end());
    s.standard_error = s.correlation_time = s.effective_samples = undefined;
    if (s.samples < samples_for_error) return s;
    s.standard_error = standard_error(known);
    s.correlation_time = correlation_time(known);
    s.effective_samples = static_cast<double>(known.size()) / (2.0 * s.correlation_time);
    return s;
}

}  // namespace tt
