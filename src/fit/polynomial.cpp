#include "fit/polynomial.hpp"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <optional>

#include "base/contracts.hpp"

namespace tt {
namespace {

struct OrderFit {
    std::vector<double> coefficients;
    double error = 0.0;
};

/// Nothing if the values do not determine a surface of this order, each of them left out. With the
/// rows of places and values times √w and A = Q R, the leverages are |Qᵢ|².
std::optional<OrderFit> fit_order(int order, std::span<const Vec2> at,
                                  std::span<const double> values, std::span<const double> weights) {
    const Eigen::Index size = Polynomial::terms(order);
    const auto count = static_cast<Eigen::Index>(values.size());
    if (count <= size) return std::nullopt;
    Eigen::MatrixXd rows(count, size);
    Eigen::VectorXd right(count);
    for (Eigen::Index n = 0; n < count; ++n) {
        const auto k = static_cast<std::size_t>(n);
        const double root = std::sqrt(weights[k]);
        const auto factors = Polynomial::factors(at[k]);
        for (Eigen::Index i = 0; i < size; ++i)
            rows(n, i) = root * factors[static_cast<std::size_t>(i)];
        right(n) = root * values[k];
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
    if (qr.rank() < size) return std::nullopt;
    const Eigen::VectorXd coefficients = qr.solve(right);
    const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(count, size);
    const Eigen::ArrayXd others = 1.0 - q.rowwise().squaredNorm().array();
    if (!(others.minCoeff() > 1e-9)) return std::nullopt;
    const Eigen::ArrayXd errors = (right - rows * coefficients).array() / others;
    double total = 0.0;
    for (const double weight : weights) total += weight;
    return OrderFit{{coefficients.begin(), coefficients.end()},
                    std::sqrt(errors.square().sum() / total)};
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
        auto fit = fit_order(order, at, values, weights);
        if (!fit || fit->error >= best.error) continue;
        best.error = fit->error;
        best.surface.coefficients = std::move(fit->coefficients);
    }
    return best;
}

}  // namespace tt
