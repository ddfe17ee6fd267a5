#pragma once

#include <cmath>

#include "base/exp.hpp"
#include "base/isa.hpp"

namespace tt {

/// Morse attraction and repulsion between two membranes a gap r apart, as a potential per area (Eq.
/// 16) φ(r) = D_e [e^{2β(r₀−r)} − 2 e^{β(r₀−r)}] and a pressure (Eq. 17, signs corrected) f(r) =
/// −dφ/dr = 2 β D_e [e^{2β(r₀−r)} − e^{β(r₀−r)}], positive = repulsive for r < r₀, there times α.
/// r < 0 (the membranes have crossed) continues the same law.
struct Morse {
    double energy = 0.0;               ///< D_e
    double decay = 1.0;                ///< β
    double zero_force_distance = 1.0;  ///< r₀
    bool scale_repulsion = false;      ///< hardening applies to contact (Table 1)

    friend bool operator==(const Morse&, const Morse&) = default;

    TT_INLINE double pressure(double gap, double alpha) const {
        const double e = vector_exp(decay * (zero_force_distance - gap));
        const double plain = 2.0 * decay * energy * (e * e - e);
        return plain > 0.0 ? alpha * plain : plain;
    }
    /// −df/dr.
    double stiffness(double gap, double alpha) const {
        const double e = std::exp(decay * (zero_force_distance - gap));
        return (e > 1.0 ? alpha : 1.0) * 2.0 * decay * decay * energy * (2.0 * e * e - e);
    }
    /// The potential whose slope `pressure` is: φ + D_e is scaled where the force is, so that φ
    /// stays continuous.
    double potential(double gap, double alpha) const {
        const double e = std::exp(decay * (zero_force_distance - gap));
        const double above_minimum = energy * (e - 1.0) * (e - 1.0);
        return (gap < zero_force_distance ? alpha : 1.0) * above_minimum - energy;
    }
};

/// Short-range repulsion, off by default: pressure p₀ (1 − r/r_s)² for gaps below r_s, p₀ at
/// contact, with a continuous slope at r_s; it goes on growing once membranes have crossed. Not
/// part of the paper: the Morse pressure is bounded and cannot stop an overlap.
struct ShortRangeRepulsion {
    double range = 0.0;     ///< r_s; 0: off
    double strength = 0.0;  ///< p₀

    TT_INLINE double pressure(double gap) const {
        const double closeness = 1.0 - gap / range;
        return gap < range ? strength * closeness * closeness : 0.0;
    }
};

}  // namespace tt
