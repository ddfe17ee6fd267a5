#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "base/choice.hpp"
#include "base/quantity.hpp"

namespace tt {

// How what drives the flow changes in time: waveform, of [flow] and of each port. Each is a factor
// of what is held otherwise.

struct SteadyWave {
    static constexpr std::string_view name = "steady";
    friend bool operator==(const SteadyWave&, const SteadyWave&) = default;
};
/// 1 + amplitude · sin(2π · frequency · t).
struct SineWave {
    static constexpr std::string_view name = "sine";
    Rate frequency;
    double amplitude = 0.5;
    friend bool operator==(const SineWave&, const SineWave&) = default;
};
/// Straight lines between points, again and again.
struct TableWave {
    static constexpr std::string_view name = "table";
    std::vector<Time> times;  ///< from 0 to the end of a period
    std::vector<double> factors;
    friend bool operator==(const TableWave&, const TableWave&) = default;
};
using WaveCase = std::variant<SteadyWave, SineWave, TableWave>;

/// The largest of its factors, whichever sign.
double largest_factor(const WaveCase& wave);
/// The highest frequency that matters, 1/(2π) of the largest slope over the largest factor; 0:
/// steady.
double frequency_of(const WaveCase& wave);

}  // namespace tt
