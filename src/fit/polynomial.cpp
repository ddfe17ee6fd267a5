#include "fit/polynomial.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "base/contracts.hpp"

namespace tt {
namespace {

constexpr int most = Polynomial::most_terms;
using Row = std::array<double, most>;

/// The lower triangle L of a symmetric positive matrix, L Lᵀ; nothing if it is none.
class Cholesky {
public:
    Cholesky(const std::array<Row, most>& matrix, int size) : size_(size) {
        for (int i = 0; i < size_; ++i) {
            for (int j = 0; j <= i; ++j) {
                double sum = matrix[i][j];
                for (int k = 0; k < j; ++k) sum -= lower_[i][k] * lower_[j][k];
                if (i != j) {
                    lower_[i][j] = sum / lower_[j][j];
                } else if (sum > 1e-12 * matrix[i][i]) {
                    lower_[i][i] = std::sqrt(sum);
                } else {
                    positive_ = false;
                    return;
                }
            }
        }
    }
    bool positive() const { return positive_; }
    /// L⁻¹ b
    Row forward(Row b) const {
        for (int i = 0; i < size_; ++i) {
            for (int k = 0; k < i; ++k) b[i] -= lower_[i][k] * b[k];
            b[i] /= lower_[i][i];
        }
        return b;
    }
    /// L⁻ᵀ b
    Row backward(Row b) const {
        for (int i = size_ - 1; i >= 0; --i) {
            for (int k = i + 1; k < size_; ++k) b[i] -= lower_[k][i] * b[k];
            b[i] /= lower_[i][i];
        }
        return b;
    }

private:
    int size_;
    bool positive_ = true;
    std::array<Row, most> lower_{};
};

double product(const Row& a, const Row& b, int size) {
    double sum = 0.0;
    for (int k = 0; k < size; ++k) sum += a[k] * b[k];
    return sum;
}

struct OrderFit {
    Row coefficients{};
    double error = 0.0;
};

/// Nothing if the values do not determine a surface of this order, each of them left out.
std::optional<OrderFit> fit_order(int order, std::span<const Vec2> at,
                                  std::span<const double> values, std::span<const double> weights) {
    const int size = Polynomial::terms(order);
    if (static_cast<int>(values.size()) <= size) return std::nullopt;
    std::array<Row, most> matrix{};
    Row right{};
    for (std::size_t n = 0; n < values.size(); ++n) {
        const Row a = Polynomial::factors(at[n]);
        for (int i = 0; i < size; ++i) {
            right[i] += weights[n] * a[i] * values[n];
            for (int j = 0; j <= i; ++j) matrix[i][j] += weights[n] * a[i] * a[j];
        }
    }
    const Cholesky cholesky(matrix, size);
    if (!cholesky.positive()) return std::nullopt;
    OrderFit fit;
    fit.coefficients = cholesky.backward(cholesky.forward(right));
    double sum = 0.0, total = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const Row a = Polynomial::factors(at[n]);
        const Row z = cholesky.forward(a);
        const double others = 1.0 - weights[n] * product(z, z, size);
        if (!(others > 1e-9)) return std::nullopt;
        const double error = (values[n] - product(fit.coefficients, a, size)) / others;
        sum += weights[n] * error * error;
        total += weights[n];
    }
    fit.error = std::sqrt(sum / total);
    return fit;
}

}  // namespace

std::array<double, Polynomial::most_terms> Polynomial::factors(Vec2 at) {
    // About the middle, where powers are least alike.
    const double x = 2.0 * at.x - 1.0, y = 2.0 * at.y - 1.0;
    return {1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y};
}

double Polynomial::operator()(Vec2 at) const {
    const auto a = factors(at);
    double sum = 0.0;
    for (std::size_t k = 0; k < coefficients.size(); ++k) sum += coefficients[k] * a[k];
    return sum;
}

int Polynomial::order() const {
    int order = 0;
    while (terms(order) < static_cast<int>(coefficients.size())) ++order;
    return order;
}

PolynomialFit fit_polynomial(std::span<const Vec2> at, std::span<const double> values,
                             std::span<const double> weights) {
    TT_EXPECTS(!values.empty() && at.size() == values.size() && weights.size() == values.size());
    PolynomialFit best;
    best.surface.coefficients = {values.front()};
    best.error = std::numeric_limits<double>::infinity();
    for (int order = 0; order <= Polynomial::highest_order; ++order) {
        const auto fit = fit_order(order, at, values, weights);
        if (!fit || fit->error >= best.error) continue;
        best.error = fit->error;
        const auto* begin = fit->coefficients.begin();
        best.surface.coefficients.assign(begin, begin + Polynomial::terms(order));
    }
    return best;
}

}  // namespace tt
