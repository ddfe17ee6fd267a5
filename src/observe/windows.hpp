#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "base/quantity.hpp"

namespace tt {

/// The averaging window.
struct Window {
    Time from, to;

    /// Times are steps · dt: the last one may exceed the end by rounding, and must not fall out.
    bool holds(double time) const {
        const double slack = 1e-9 * std::abs(to.si);
        return time >= from.si - slack && time <= to.si + slack;
    }
    double length() const { return to.si - from.si; }
};

/// What a window of evenly spaced samples tells of a quantity. NaN where it is not defined.
struct WindowStatistics {
    std::int64_t samples = 0;  ///< those that are numbers
    double mean = 0.0;
    double sd = 0.0;  ///< with n − 1; NaN for fewer than two samples
    double smallest = 0.0, largest = 0.0;
    double standard_error = 0.0;    ///< of the mean; NaN for fewer than `samples_for_error` samples
    double correlation_time = 0.0;  ///< ½ + Σ ρ_k, in samples; NaN as the error
    double effective_samples = 0.0;  ///< independent ones that the window is worth
};

/// Ten batches of two.
inline constexpr std::int64_t samples_for_error = 20;

/// Samples that are NaN are left out.
///
/// Successive samples are correlated, so sd/√n would promise too much. The standard error is that
/// of batch means: the window is cut into 10 batches of equal length (what is left over is dropped
/// at the start); if a batch outlasts the correlation the batch means are independent, and the
/// error is their sd/√10, itself known to 1/√18 = 24 %. Ten because more batches gain little and
/// ask for a longer window (Schmeiser, Oper. Res. 30 (1982) 556).
///
/// Batch means cannot tell that a window is too short: those of a drift look like ten independent
/// samples. The correlation time can: ½ + Σ ρ_k over the lags k up to five times itself, where the
/// noise of more lags outweighs their correlation (Sokal, in Functional Integration (1997), p.
/// 131). For ρ = exp(−t/τ) it is τ, and n samples are worth n/(2 τ) independent ones.
WindowStatistics window_statistics(std::span<const double> samples);

}  // namespace tt
