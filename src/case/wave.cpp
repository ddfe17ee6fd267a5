#include "case/wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tt {

double largest_factor(const WaveCase& wave) {
    if (const auto* sine = std::get_if<SineWave>(&wave)) return 1.0 + std::fabs(sine->amplitude);
    double largest = 1.0;
    if (const auto* table = std::get_if<TableWave>(&wave)) {
        largest = 0.0;
        for (const double factor : table->factors) largest = std::max(largest, std::fabs(factor));
    }
    return largest;
}

double frequency_of(const WaveCase& wave) {
    if (const auto* sine = std::get_if<SineWave>(&wave)) return sine->frequency.si;
    double steepest = 0.0;
    if (const auto* table = std::get_if<TableWave>(&wave))
        for (std::size_t k = 1; k < std::min(table->times.size(), table->factors.size()); ++k)
            steepest = std::max(steepest, std::fabs(table->factors[k] - table->factors[k - 1]) /
                                              (table->times[k].si - table->times[k - 1].si));
    const double largest = largest_factor(wave);
    return largest > 0.0 ? steepest / (2.0 * std::numbers::pi * largest) : 0.0;
}

}  // namespace tt
