#pragma once

#include <string_view>

#include "coupling/interface/area_fraction.hpp"

namespace tt {

/// The exact area fraction, smoothed `passes` times by ¼, ½, ¼ along x and along y: one pass is the
/// convolution with the cosine delta (Eq. 8 takes these values at distances −1, 0, 1), so that
/// viscosity and force have the same width, ± 1½ sites with one pass and one more with each other.
/// Keeps the area; a flat membrane's fraction is ½ on it. Much cheaper than a signed distance.
struct BlurredFraction {
    static constexpr std::string_view name = "blurred-fraction";
    int passes = 1;
    double reach() const { return passes; }

    template <class Interior>
    void operator()(const Interior&, const LocalOutline& outline, Patch& patch) const {
        AreaFraction::cover(outline, patch);
        for (int pass = 0; pass < passes; ++pass) blur(patch);
    }

private:
    static void blur(Patch& patch);
};

}  // namespace tt
