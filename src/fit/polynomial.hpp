#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// Σ c_ij x^i y^j over i + j ≤ order, with x and y in 0 … 1.
struct Polynomial {
    static constexpr int highest_order = 3;
    static constexpr int most_terms = (highest_order + 1) * (highest_order + 2) / 2;

    static int terms(int order) { return (order + 1) * (order + 2) / 2; }
    /// What the coefficients are multiplied with at a place, lowest order first.
    static std::array<double, most_terms> factors(Vec2 at);

    double operator()(Vec2 at) const;
    int order() const;

    std::vector<double> coefficients{0.0};
};

/// A polynomial through scattered values, and how far it is from a value that it has not seen.
struct PolynomialFit {
    Polynomial surface;
    double error = 0.0;  ///< weighted rms of leaving each value out in turn
};

/// Weighted least squares with the order, 0 to 3, that predicts left-out values best: so that few
/// or noisy values do not get a surface that follows each of them. The errors of leaving one out
/// follow from one fit: e_i = r_i / (1 − w_i aᵢᵀ (Σ w a aᵀ)⁻¹ aᵢ) with the residuals r and factors
/// a. Precondition: at least one value, as many places and weights, weights positive.
PolynomialFit fit_polynomial(std::span<const Vec2> at, std::span<const double> values,
                             std::span<const double> weights);

}  // namespace tt
