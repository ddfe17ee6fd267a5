#pragma once

#include <string_view>
#include <tuple>
#include <variant>

#include "base/field_list.hpp"
#include "base/isa.hpp"

namespace tt {

/// 1/τ⁺ and 1/τ⁻ of a site.
struct Rates {
    double even, odd;
};

/// Two relaxation times (Ginzburg 2005): (τ⁺ − ½)(τ⁻ − ½) = Λ. Λ = 3/16 puts half-way walls exactly
/// for Poiseuille flow whatever the viscosity.
struct Trt {
    static constexpr std::string_view name = "trt";
    double magic = 3.0 / 16.0;
    /// 1/τ⁻ that belongs to 1/τ⁺ = even.
    double odd_rate(double even) const {
        const double half_step = 1.0 / even - 0.5;
        return half_step / (0.5 * half_step + magic);
    }
    /// Both rates for lattice kinematic viscosity ν = (τ⁺ − ½)/3, with one division for the two.
    TT_INLINE Rates rates(double viscosity) const {
        const double half_step = 3.0 * viscosity;
        const double even = half_step + 0.5;         // τ⁺
        const double odd = 0.5 * half_step + magic;  // τ⁻ · half_step
        const double inverse = 1.0 / (even * odd);
        return {odd * inverse, half_step * even * inverse};
    }
    friend bool operator==(const Trt&, const Trt&) = default;
};

template <>
struct FieldList<Trt> {
    static constexpr auto entries =
        std::tuple{FieldEntry{"magic",
                              &Trt::magic,
                              "Lambda of TRT; 3/16 puts walls exactly half-way",
                              Range{1e-3, 10.0},
                              {},
                              "0.1875"}};
};

/// One relaxation time (Eq. 1 of the paper).
struct Bgk {
    static constexpr std::string_view name = "bgk";
    double odd_rate(double even) const { return even; }
    TT_INLINE Rates rates(double viscosity) const {
        const double even = 1.0 / (3.0 * viscosity + 0.5);
        return {even, even};
    }
    friend bool operator==(const Bgk&, const Bgk&) = default;
};

using Collision = std::variant<Trt, Bgk>;

/// 1/τ⁺ of the lattice kinematic viscosity ν = (τ − ½)/3.
inline double even_rate(double viscosity) { return 1.0 / (3.0 * viscosity + 0.5); }

}  // namespace tt
