#pragma once

#include <string_view>
#include <tuple>

#include "base/field_list.hpp"
#include "base/isa.hpp"

namespace tt {

/// Skalak's law (Skalak, Tözeren, Zarda, Chien 1973) for a strip stretched along one axis with the
/// other held, λ₁ = λ, λ₂ = 1: the 2D section of a membrane that resists dilation. In the
/// normalisation of Barthès-Biesel, W_3D = G_s/4 [I₁² + 2 I₁ − 2 I₂ + C I₂²], here I₁ = I₂ = λ² −
/// 1, so W = G_s/4 (1 + C)(λ² − 1)² and T = dW/dλ = G_s (1 + C) λ (λ² − 1). Small strains: T = 2
/// G_s (1 + C)(λ − 1); with C = ½ the slope is that of Eq. 10.
struct Skalak {
    static constexpr std::string_view name = "skalak";
    double shear_modulus = 0.0;        ///< G_s, the paper's E_s
    double area_dilation_ratio = 1.0;  ///< C

    TT_INLINE double tension(double stretch) const {
        return shear_modulus * (1.0 + area_dilation_ratio) * stretch * (stretch * stretch - 1.0);
    }
    TT_INLINE double slope(double stretch) const {
        return shear_modulus * (1.0 + area_dilation_ratio) * (3.0 * stretch * stretch - 1.0);
    }
    double energy(double stretch) const {
        const double dilation = stretch * stretch - 1.0;
        return 0.25 * shear_modulus * (1.0 + area_dilation_ratio) * dilation * dilation;
    }
    friend bool operator==(const Skalak&, const Skalak&) = default;
};

template <>
struct FieldList<Skalak> {
    static constexpr auto entries = std::tuple{FieldEntry{"area_dilation_ratio",
                                                          &Skalak::area_dilation_ratio,
                                                          "C of the Skalak law",
                                                          Range{0.0, 1e6},
                                                          {},
                                                          "1"}};
};

}  // namespace tt
