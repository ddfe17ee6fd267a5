#include "simulation/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tt {

double Waveform::at(double step) const {
    if (time.empty()) return 1.0 + amplitude * std::sin(2.0 * std::numbers::pi * frequency * step);
    const double period = time.back();  // the first is 0
    const double now = step - period * std::floor(step / period);
    const auto after = std::upper_bound(time.begin(), time.end() - 1, now);
    const std::size_t k = static_cast<std::size_t>(after - time.begin());
    const double share = (now - time[k - 1]) / (time[k] - time[k - 1]);
    return factor[k - 1] + share * (factor[k] - factor[k - 1]);
}

}  // namespace tt
