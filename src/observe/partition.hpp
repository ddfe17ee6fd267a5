#pragma once

#include "base/quantity.hpp"

namespace tt {

/// The empirical law of phase separation at a fork of Pries and Secomb (2005), of microvessels of
/// the rat, round tubes: with the share x of the blood flow a daughter takes the share
///
///     y = 0 for x ≤ X₀,   logit y = A + B logit((x − X₀)/(1 − 2 X₀)),   1 for x ≥ 1 − X₀
///
/// of the red cells. X₀ = 0.964 (1 − H)/D_F, B = 1 + 6.98 (1 − H)/D_F, A = −13.29
/// ((D_α² − D_β²)/(D_α² + D_β²)) (1 − H)/D_F, diameters in µm of feeding vessel, this daughter and
/// the other, H the discharge hematocrit of the feeding vessel. Of channels that are flat it is a
/// curve to look at, no bound.
struct PriesLaw {
    double X0 = 0.0, A = 0.0, B = 1.0;

    PriesLaw(Length feeding, Length daughter, Length other, double discharge_hematocrit);
    double cell_fraction(double flow_fraction) const;
};

}  // namespace tt
