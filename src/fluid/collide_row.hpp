#pragma once

#include <array>
#include <type_traits>

#include "base/isa.hpp"
#include "base/vec2.hpp"
#include "fluid/equilibrium.hpp"
#include "grid/d2q9.hpp"

namespace tt {

/// One row of sites as the collision sees it: pointers to the first of `count` sites. All
/// fields are in the same precision, double or float.
template <class Real>
struct RowOfSites {
    int count;
    std::array<Real*, d2q9::count> at;  ///< Populations::arrivals
    const Real* force_x;
    const Real* force_y;
    Vec2 body_force;
    const Real* even;  ///< ω⁺
    const Real* odd;   ///< ω⁻
    Real* velocity_x;
    Real* velocity_y;
};

/// Collides a row of sites in place. The velocity may take the place of the force.
///
/// Two relaxation times work on pairs of opposite populations: with s = f_i + f_ī, d = f_i − f_ī,
///
///     g_i, g_ī = ½(s′ ± d′),
///     s′ = s − ω⁺ (s − s^eq) + (1 − ω⁺/2) s^B,
///     d′ = d − ω⁻ (d − d^eq) + (1 − ω⁻/2) d^B,
///
/// s^B, d^B being the parts of Guo's forcing. With momentum m = Σ f c + ½F all equilibria share
/// d^eq = 6 w_i c_i·m and d^B = 6 w_i c_i·F, so that ½F drops out of the odd part:
///
///     ½d′ = ½(1 − ω⁻) d + w_i c_i·P,  P = 3 (ω⁻ Σ f c + F).
///
/// Even part: ½s′ = ½(1 − ω⁺) s + w_i e_i with e_i = ω⁺ δρ in the linear equilibrium; the others
/// add, with v = ½ω⁺ m + (1 − ½ω⁺) F, which joins the quadratic terms of f^eq and of the forcing,
///
///     e_i = ω⁺ δρ + 9 (c_i·u)(c_i·v) − 3 u·v.
///
/// Weights are multiplied in where that takes the fewest operations, which the pass has to wait for
/// as much as for memory: w = 1/9 along the axes, a quarter of it along the diagonals, four times
/// as much at rest. They multiply what the rates have been multiplied with, not the rates: a
/// product of the two would be rounded once for all, and mass and momentum change by that share in
/// every step (in single precision nodes were then off by 4·10⁻³ instead of 4·10⁻⁵ sites after 4000
/// steps).
///
/// The populations departing stand where those arriving stood: g_i in the place of f_ī.
template <class AnEquilibrium, class Real>
TT_INLINE void collide_row_with(const RowOfSites<Real>& row) {
    constexpr bool linear = std::is_same_v<AnEquilibrium, LinearEquilibrium>;
    constexpr bool full = std::is_same_v<AnEquilibrium, FullEquilibrium>;
    static_assert(d2q9::weight[0] == 4 * d2q9::weight[1] && d2q9::weight[1] == 4 * d2q9::weight[5]);
    constexpr Real one = 1, half = 0.5, quarter = 0.25, third = 1.0 / 3.0, four = 4;
    constexpr Real w_axis = d2q9::weight[1];
    // One pointer each: clang 14 takes no structured binding into a loop of `omp simd`.
    Real* const f0 = row.at[0];
    Real *const f1 = row.at[1], *const f2 = row.at[2], *const f3 = row.at[3], *const f4 = row.at[4];
    Real *const f5 = row.at[5], *const f6 = row.at[6], *const f7 = row.at[7], *const f8 = row.at[8];
    const Real *const force_x = row.force_x, *const force_y = row.force_y;
    Real *const velocity_x = row.velocity_x, *const velocity_y = row.velocity_y;
    const Real *const rates_even = row.even, *const rates_odd = row.odd;
    const int count = row.count;
    const Real body_x = row.body_force.x, body_y = row.body_force.y;

#pragma omp simd
    for (int i = 0; i < count; ++i) {
        // The pairs along x, y, the rising diagonal (1, 1) and the falling one (−1, 1).
        const Real rest = f0[i];
        const Real sum_x = f1[i] + f3[i], difference_x = f1[i] - f3[i];
        const Real sum_y = f2[i] + f4[i], difference_y = f2[i] - f4[i];
        const Real sum_r = f5[i] + f7[i], difference_r = f5[i] - f7[i];
        const Real sum_f = f6[i] + f8[i], difference_f = f6[i] - f8[i];

        const Real density_deviation = rest + ((sum_x + sum_y) + (sum_r + sum_f));
        const Real flux_x = difference_x + (difference_r - difference_f);
        const Real flux_y = difference_y + (difference_r + difference_f);
        const Real fx = force_x[i] + body_x;
        const Real fy = force_y[i] + body_y;
        const Real momentum_x = flux_x + half * fx;
        const Real momentum_y = flux_y + half * fy;
        Real ux = momentum_x;
        Real uy = momentum_y;
        if constexpr (full) {
            const Real volume = one / (one + density_deviation);
            ux *= volume;
            uy *= volume;
        }
        velocity_x[i] = ux;
        velocity_y[i] = uy;

        // w e of the axes but for their own square, the squares, and of the diagonals together.
        const Real even = rates_even[i];
        const Real half_even = half * even;
        const Real keep_even = half - half_even;
        Real e = w_axis * (even * density_deviation);
        Real xx{}, yy{}, e_r = e, e_f = e;
        if constexpr (!linear) {
            const Real keep_force = one - half_even;
            const Real vx = half_even * momentum_x + keep_force * fx;
            const Real vy = half_even * momentum_y + keep_force * fy;
            xx = ux * vx;
            yy = uy * vy;
            const Real squares = xx + yy;
            const Real mixed = ux * vy + uy * vx;
            e = e - third * squares;
            e_r = (e + squares) + mixed;
            e_f = (e + squares) - mixed;
        }
        const Real odd = rates_odd[i];
        const Real keep_odd = half - half * odd;
        const Real push_x = third * (odd * flux_x + fx);
        const Real push_y = third * (odd * flux_y + fy);

        const auto depart = [i](Real* forth, Real* back, Real even_part, Real odd_part) {
            back[i] = even_part + odd_part;
            forth[i] = even_part - odd_part;
        };
        f0[i] = (one - even) * rest + four * e;
        depart(f1, f3, keep_even * sum_x + (e + xx), keep_odd * difference_x + push_x);
        depart(f2, f4, keep_even * sum_y + (e + yy), keep_odd * difference_y + push_y);
        depart(f5, f7, keep_even * sum_r + quarter * e_r,
               keep_odd * difference_r + quarter * (push_y + push_x));
        depart(f6, f8, keep_even * sum_f + quarter * e_f,
               keep_odd * difference_f + quarter * (push_y - push_x));
    }
}

/// `collide_row_with`, compiled for each level of the instruction set.
void collide_row(LinearEquilibrium, const RowOfSites<double>& row);
void collide_row(LinearEquilibrium, const RowOfSites<float>& row);
void collide_row(IncompressibleEquilibrium, const RowOfSites<double>& row);
void collide_row(IncompressibleEquilibrium, const RowOfSites<float>& row);
void collide_row(FullEquilibrium, const RowOfSites<double>& row);
void collide_row(FullEquilibrium, const RowOfSites<float>& row);

}  // namespace tt
