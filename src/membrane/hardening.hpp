#pragma once

#include <cmath>
#include <cstdint>

#include "base/choice.hpp"

namespace tt {

/// The large-deformation coefficient α(λ) and the modalities it scales (Eq. 12, Table 1). As
/// printed α(1) ≠ 1 unless β = 1; both repairs are offered. α'(1) = Dβ (exponential) or eDβ
/// (power-exponential).
struct Hardening {
    enum class Form : std::uint8_t { exponential, power_exponential };
    enum class Compression : std::uint8_t { symmetric, one, as_printed };

    Form form = Form::exponential;
    Compression compression = Compression::symmetric;
    double D = 0.0;  ///< 0: none
    double beta = 1.0;
    bool shear = false, bending = false, area = false, contact = false;  ///< what it scales

    /// α(λ). For λ < 1: symmetric α(2 − λ), one, or the formula as printed (which falls below 1 and
    /// lets segments collapse).
    double operator()(double stretch) const {
        if (D == 0.0) return 1.0;
        if (stretch < 1.0 && compression == Compression::one) return 1.0;
        const double s =
            stretch < 1.0 && compression == Compression::symmetric ? 2.0 - stretch : stretch;
        if (form == Form::exponential) return 1.0 + D * std::expm1(beta * (s - 1.0));
        return 1.0 + D * (std::exp(std::pow(s, beta)) - std::exp(1.0));
    }

    /// dα/dλ.
    double slope(double stretch) const {
        const bool compressed = stretch < 1.0;
        if (D == 0.0 || (compressed && compression == Compression::one)) return 0.0;
        const bool folded = compressed && compression == Compression::symmetric;
        const double s = folded ? 2.0 - stretch : stretch;
        const double power = std::pow(s, beta);
        return (folded ? -1.0 : 1.0) * D * beta *
               (form == Form::exponential ? std::exp(beta * (s - 1.0))
                                          : power / s * std::exp(power));
    }
};

template <>
inline constexpr auto words_of<Hardening::Form> =
    std::to_array<std::string_view>({"exponential", "power-exponential"});
template <>
inline constexpr auto words_of<Hardening::Compression> =
    std::to_array<std::string_view>({"symmetric", "one", "as-printed"});

/// Case III of Table 1: all four modalities hardened, exponentially.
constexpr Hardening hardened_throughout(double D, double beta) {
    return {Hardening::Form::exponential,
            Hardening::Compression::symmetric,
            D,
            beta,
            true,
            true,
            true,
            true};
}

}  // namespace tt
