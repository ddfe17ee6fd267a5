#pragma once

#include <vector>

#include "io/json.hpp"
#include "report/page_data.hpp"
#include "report/results.hpp"

namespace tt {

/// What cells.csv holds of every cell, for the curves and colours of the page: {keys: [{key, unit,
/// meaning}], count, time, values}. `values` is base64 of 32-bit floats, by key, row and cell; NaN
/// where there is none. The rows are those nearest to `frame_times` [s], and of the others as many,
/// evenly, as limits.cell_bytes allows. null without cells.
Json cell_data(const Results& run, const std::vector<double>& frame_times,
               const PageLimits& limits);

}  // namespace tt
