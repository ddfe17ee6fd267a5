#pragma once

#include <string_view>
#include <variant>

#include "base/isa.hpp"

namespace tt {

/// ν of a site of which the share `fraction` is cytoplasm. Exact for shear along layers that lie
/// across the velocity gradient in parallel: the mean stress at given shear rate.
struct ArithmeticMean {
    static constexpr std::string_view name = "arithmetic";
    TT_INLINE double operator()(double plasma, double cytoplasm, double fraction) const {
        return plasma + (cytoplasm - plasma) * fraction;
    }
    /// What of a full site adds up where several fluids share one.
    double excess(double plasma, double cytoplasm) const { return cytoplasm - plasma; }
    friend bool operator==(const ArithmeticMean&, const ArithmeticMean&) = default;
};

/// 1/ν is averaged: layers in series, the mean shear rate at given shear stress, as across a
/// membrane along the flow.
struct HarmonicMean {
    static constexpr std::string_view name = "harmonic";
    TT_INLINE double operator()(double plasma, double cytoplasm, double fraction) const {
        return plasma * cytoplasm / (cytoplasm + (plasma - cytoplasm) * fraction);
    }
    double excess(double plasma, double cytoplasm) const { return 1.0 / cytoplasm - 1.0 / plasma; }
    friend bool operator==(const HarmonicMean&, const HarmonicMean&) = default;
};

using ViscosityMean = std::variant<ArithmeticMean, HarmonicMean>;

}  // namespace tt
