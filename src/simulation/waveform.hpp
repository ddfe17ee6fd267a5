#pragma once

#include <vector>

namespace tt {

/// By how many times what drives the flow is what it is on the whole, over time: 1 if steady,
/// 1 + a sin(2π f t), or between the points of a table, which repeats. Times in steps.
struct Waveform {
    double amplitude = 0.0;  ///< a
    double frequency = 0.0;  ///< f
    std::vector<double> time, factor;

    bool steady() const { return amplitude == 0.0 && time.empty(); }
    double at(double step) const;
};

}  // namespace tt
