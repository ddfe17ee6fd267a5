#include "membrane/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tt {
namespace {

constexpr int dense = 20000;  ///< points of a curve before its nodes are spread along it

/// The closed curve p(θ), 0 ≤ θ < 2π, densely.
template <class F>
std::vector<Vec2> traced(F&& p) {
    std::vector<Vec2> curve(dense);
    for (int k = 0; k < dense; ++k) curve[k] = p(2.0 * std::numbers::pi * k / dense);
    return curve;
}

}  // namespace

std::vector<Vec2> circle(double radius, int nodes) {
    std::vector<Vec2> points(nodes);
    for (int k = 0; k < nodes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / nodes;
        points[k] = {radius * std::cos(angle), radius * std::sin(angle)};
    }
    return points;
}

std::vector<Vec2> ellipse(double major, double minor, int nodes) {
    return at_equal_arc_length(traced([&](double t) {
                                   return Vec2{major * std::cos(t), minor * std::sin(t)};
                               }),
                               nodes);
}

std::vector<Vec2> biconcave(double half_length, int nodes) {
    const auto point = [&](double t) {
        const double x = std::cos(t);
        const double thickness = 0.207161 + 2.002558 * x * x - 1.122762 * x * x * x * x;
        return Vec2{half_length * x, 0.5 * half_length * std::sin(t) * thickness};
    };
    return at_equal_arc_length(traced(point), nodes);
}

std::vector<Vec2> at_equal_arc_length(const std::vector<Vec2>& curve, int nodes) {
    const double spacing = perimeter_of(curve) / nodes;
    std::vector<Vec2> points;
    points.reserve(nodes);
    double walked = 0.0;
    for (std::size_t k = 0; k < curve.size(); ++k) {
        const Vec2 edge = curve[(k + 1) % curve.size()] - curve[k];
        const double length = norm(edge);
        while (static_cast<int>(points.size()) < nodes &&
               spacing * points.size() <= walked + length) {
            points.push_back(curve[k] +
                             (length > 0.0 ? (spacing * points.size() - walked) / length : 0.0) *
                                 edge);
        }
        walked += length;
    }
    while (static_cast<int>(points.size()) < nodes) points.push_back(curve.back());
    return points;
}

double perimeter_of(const std::vector<Vec2>& curve) {
    double sum = 0.0;
    for (std::size_t k = 0; k < curve.size(); ++k)
        sum += norm(curve[(k + 1) % curve.size()] - curve[k]);
    return sum;
}

double area_of(const std::vector<Vec2>& curve) {
    double doubled = 0.0;
    for (std::size_t k = 0; k < curve.size(); ++k)
        doubled += cross(curve[k], curve[(k + 1) % curve.size()]);
    return 0.5 * doubled;
}

Vec2 centroid_of(const std::vector<Vec2>& curve) {
    const Vec2 origin = curve.front();
    double area = 0.0;
    Vec2 moment;
    for (std::size_t k = 0; k < curve.size(); ++k) {
        const Vec2 a = curve[k] - origin, b = curve[(k + 1) % curve.size()] - origin;
        area += cross(a, b) / 2.0;
        moment += (cross(a, b) / 6.0) * (a + b);
    }
    return origin + moment / area;
}

std::vector<Vec2> smoothed(const std::vector<Vec2>& curve, double length) {
    constexpr double points_a_length = 4.0, most = 200'000.0;
    const double perimeter = perimeter_of(curve);
    const int n =
        static_cast<int>(std::clamp(std::ceil(points_a_length * perimeter / length), 16.0, most));
    const std::vector<Vec2> even = at_equal_arc_length(curve, n);
    const int reach = std::min(n / 2, static_cast<int>(std::ceil(4.0 * length * n / perimeter)));
    std::vector<double> weights;
    double sum = 0.0;
    for (int m = -reach; m <= reach; ++m) {
        const double distance = m * perimeter / (n * length);
        weights.push_back(std::exp(-0.5 * distance * distance));
        sum += weights.back();
    }
    std::vector<Vec2> smooth(n);
    for (int k = 0; k < n; ++k)
        for (int m = -reach; m <= reach; ++m)
            smooth[k] += (weights[m + reach] / sum) * even[(k + m + n) % n];
    const Vec2 centre = centroid_of(smooth);
    const double scale = std::sqrt(area_of(curve) / area_of(smooth));
    for (Vec2& p : smooth) p = centre + scale * (p - centre);
    return smooth;
}

std::vector<Vec2> placed(std::vector<Vec2> curve, double angle, Vec2 shift) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (Vec2& p : curve) p = Vec2{c * p.x - s * p.y, s * p.x + c * p.y} + shift;
    return curve;
}

}  // namespace tt
