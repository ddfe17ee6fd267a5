#pragma once

#include <cstdint>

#include "verify/experiment.hpp"

namespace tt {

/// Two different cells, near enough to touch, in shear: every pass of a step at work.
Experiment crowded_shear(int threads);

/// What a hundred steps of a stretched cell that relaxes in a box without walls add to the fluid's
/// momentum, over Σ |force| of its nodes in one step, and to its mass, relative. Both 0 but for
/// rounding: a membrane's forces sum to zero and spreading keeps sums.
struct Drift {
    double momentum = 0.0;
    double mass = 0.0;
};
Drift drift_of_relaxing_cell();

/// Does `crowded_shear` end in the same bits on this many threads as on one?
bool same_bits_on_threads(int threads);

/// Does `crowded_shear` end in the same bits when it is saved, loaded and continued half-way?
/// Writes a file to the system's directory for temporary ones, and removes it.
bool same_bits_after_restart();

}  // namespace tt
