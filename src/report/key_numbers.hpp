#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/results.hpp"

namespace tt {

/// What a reader asks first of a run: Reynolds and shear numbers, wall stress, velocity,
/// hematocrit. SI; NaN where a run does not tell it.
struct KeyNumbers {
    double shear_rate = 0.0;         ///< k: of the walls, or mean velocity / width, as it was
    double shear_number = 0.0;       ///< G = μ k a / E_s (Eq. 19), nominal, of summary.json
    double cell_reynolds = 0.0;      ///< ρ k a² / μ, a of the circle of a cell's area
    double cell_reynolds_run = 0.0;  ///< times the density scale: as it was computed
    double channel_reynolds = 0.0;   ///< ρ U H / μ
    double wall_shear_stress = 0.0;  ///< [Pa]
    double mean_velocity = 0.0;      ///< U [m/s]
    double hematocrit = 0.0;         ///< share of the box
};

/// Means are over the averaging window (window_mean).
KeyNumbers key_numbers(const Results& run);

std::string key_numbers_section(std::span<const Results> runs,
                                const std::vector<std::string>& labels);

}  // namespace tt
