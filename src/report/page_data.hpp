#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/json.hpp"
#include "report/results.hpp"

namespace tt {

/// How much of a run the page may carry. What is left out is said on the page.
struct PageLimits {
    std::size_t rows = 1000;   ///< of a time series
    std::size_t frames = 240;  ///< of the player
    std::size_t nodes_per_cell = 96;
    std::size_t node_bytes = 3 << 20;   ///< before base64, shared by all runs
    std::size_t field_bytes = 3 << 19;  ///< of the speed behind the cells, likewise
    std::size_t cell_bytes = 1 << 20;   ///< of what is told of each cell, likewise
};

/// A run as the charts and the player of the page take it: {label, columns, cells, player}.
Json run_data(const Results& run, const std::string& label, const PageLimits& limits);

/// Its time series: [{key, unit, meaning, values}]. Values keep six digits.
Json series_data(const Results& run, const PageLimits& limits);

/// Its frames: positions as 16-bit multiples of `quantum`, wrapped cell by cell; stretch and speed
/// as bytes; all base64. null if there are no frames.
Json player_data(const Results& run, const PageLimits& limits);

/// With six digits; null if it is not finite.
Json rounded(double value);

std::string base64(std::string_view bytes);

}  // namespace tt
