#include "membrane/outline.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "ellipse.hpp"

namespace tt {
namespace {

using test::Ellipse;
using test::pi;

struct Shape {
    std::vector<double> x, y;
    explicit Shape(const std::vector<Vec2>& points) {
        for (Vec2 p : points) {
            x.push_back(p.x);
            y.push_back(p.y);
        }
    }
    operator Outline() const { return {x, y}; }
};

const Shape l_shape({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});

/// Errors at 32, 64, 128 and 256 nodes must fall at least as fast as `order`.
template <class F>
void expect_order(const std::string& what, double order, F&& error) {
    double before = error(32);
    for (int n : {64, 128, 256}) {
        const double now = error(n);
        const double seen = std::log2(before / now);
        fmt::print("{:16} {:4} nodes: error {:.3e}, order {:.2f}\n", what, n, now, seen);
        EXPECT_GT(seen, order - 0.1) << what << " at " << n << " nodes";
        before = now;
    }
}

TEST(Outline, area_centroid_and_moments_of_a_polygon_are_exact) {
    // Two rectangles: 3 × 1 about (1.5, .5) and 1 × 1 about (.5, 1.5).
    const AreaMoments m = area_moments(l_shape);
    EXPECT_NEAR(signed_area(l_shape), 4.0, 1e-14);
    EXPECT_NEAR(m.area, 4.0, 1e-14);
    EXPECT_NEAR(m.centroid.x, (3 * 1.5 + 0.5) / 4, 1e-14);
    EXPECT_NEAR(m.centroid.y, (3 * 0.5 + 1.5) / 4, 1e-14);
    const double cx = 1.25, cy = 0.75;
    const double xx = 27.0 / 12 + 3 * 0.25 * 0.25 + 1.0 / 12 + 0.75 * 0.75;
    const double yy = 3.0 / 12 + 3 * 0.25 * 0.25 + 1.0 / 12 + 0.75 * 0.75;
    const double xy = 3 * (1.5 - cx) * (0.5 - cy) + (0.5 - cx) * (1.5 - cy);
    EXPECT_NEAR(m.xx, xx, 1e-13);
    EXPECT_NEAR(m.yy, yy, 1e-13);
    EXPECT_NEAR(m.xy, xy, 1e-13);
    EXPECT_NEAR(perimeter(l_shape), 10.0, 1e-14);
}

TEST(Outline, a_clockwise_outline_has_negative_area) {
    const Shape backwards({{0, 0}, {0, 2}, {1, 2}, {1, 1}, {3, 1}, {3, 0}});
    EXPECT_NEAR(signed_area(backwards), -4.0, 1e-14);
}

/// Length of the lines y = row + ½ inside a shape, row by row.
std::map<int, double> lengths_inside(const Shape& shape) {
    std::map<int, double> inside;
    for (const RowCrossing& crossing : row_crossings(shape))
        inside[crossing.row] += crossing.turn * crossing.x;
    return inside;
}

TEST(Outline, crossings_of_rows_are_exact_for_a_polygon) {
    using Lengths = std::map<int, double>;
    EXPECT_EQ(lengths_inside(l_shape), (Lengths{{0, 3.0}, {1, 1.0}}));
    const Shape u_shape({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    EXPECT_EQ(lengths_inside(u_shape), (Lengths{{0, 3.0}, {1, 2.0}})) << "two parts";
    Shape on_nodes = l_shape;
    for (double& y : on_nodes.y) y -= 0.5;
    EXPECT_EQ(lengths_inside(on_nodes), (Lengths{{0, 3.0}, {1, 1.0}}))
        << "through nodes: the side below";
    for (const RowCrossing& crossing : row_crossings(l_shape))
        EXPECT_EQ(crossing.turn, crossing.x > 0.0 ? 1 : -1);
}

TEST(Outline, measures_converge_to_those_of_an_ellipse_at_second_order) {
    const Ellipse ellipse{{12.3, -4.5}, 3.0, 2.0, 0.6};
    const double h = std::pow((3.0 - 2.0) / (3.0 + 2.0), 2);
    const double ramanujan = pi * 5.0 * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));  // to 1e-9
    const auto shape = [&](int n) { return Shape(ellipse.nodes(n, 0.3)); };
    const auto axes = [&](int n) { return equivalent_ellipse(area_moments(shape(n))); };
    expect_order("area", 2, [&](int n) { return std::abs(signed_area(shape(n)) / (6 * pi) - 1); });
    expect_order("perimeter", 2,
                 [&](int n) { return std::abs(perimeter(shape(n)) / ramanujan - 1); });
    expect_order("major", 2, [&](int n) { return std::abs(axes(n).major - 3.0); });
    expect_order("minor", 2, [&](int n) { return std::abs(axes(n).minor - 2.0); });
    // The tips lie at a fixed fraction of a segment, else the order seen is that of luck.
    const auto between = [&](int n) { return Shape(ellipse.nodes(n, 0.3 * 2 * pi / n)); };
    expect_order("largest radius", 4, [&](int n) {
        const Shape s = between(n);
        return std::abs(radius_range(s, area_moments(s).centroid).largest - 3.0);
    });
    expect_order("smallest radius", 4, [&](int n) {
        const Shape s = between(n);
        return std::abs(radius_range(s, area_moments(s).centroid).smallest - 2.0);
    });
    expect_order("curvature", 2, [&](int n) {  // node n/4 is at θ = 0.3 + π/2
        const double s = 3.0 * std::sin(0.3 + pi / 2), c = 2.0 * std::cos(0.3 + pi / 2);
        const double exact = 6.0 / std::pow(s * s + c * c, 1.5);
        return std::abs(curvature(shape(n), n / 4) / exact - 1);
    });
}

TEST(Outline, area_of_a_circle_of_nodes_is_low_by_two_thirds_of_pi_squared_over_n_squared) {
    for (int n : {24, 120}) {
        const Shape circle(Ellipse{{}, 1.0, 1.0, 0.0}.nodes(n));
        const double leading = 2 * pi * pi / (3.0 * n * n);
        EXPECT_NEAR((1 - signed_area(circle) / pi) / leading, 1.0, 0.02) << n;
    }
}

TEST(Outline, taylor_deformation_and_inclination_of_an_ellipse_of_nodes_are_exact) {
    // Both second moments of a polygon with evenly spaced θ are low by the same factor, which
    // cancels.
    for (double degrees : {-89.0, -30.0, 0.0, 17.0, 45.0, 89.0, 90.0}) {
        const Shape shape(Ellipse{{3.0, 2.0}, 3.0, 2.0, degrees * pi / 180}.nodes(48, 0.1));
        const EquivalentEllipse e = equivalent_ellipse(area_moments(shape));
        EXPECT_NEAR(taylor_deformation(e.major, e.minor), 0.2, 1e-13);
        EXPECT_NEAR(std::abs(std::sin(e.inclination - degrees * pi / 180)), 0.0, 1e-12) << degrees;
        EXPECT_GT(e.inclination, -pi / 2);
        EXPECT_LE(e.inclination, pi / 2);
    }
}

TEST(Outline, a_circle_has_no_deformation_and_inclination_zero) {
    const Shape circle(Ellipse{{1e3, 7.0}, 5.0, 5.0, 0.0}.nodes(64, 0.2));
    const EquivalentEllipse e = equivalent_ellipse(area_moments(circle));
    EXPECT_NEAR(taylor_deformation(e.major, e.minor), 0.0, 1e-13);
    const RadiusRange r = radius_range(circle, area_moments(circle).centroid);
    EXPECT_NEAR(taylor_deformation(r.largest, r.smallest), 0.0, 1e-12);
}

TEST(Outline, deformation_by_radii_does_not_jitter_as_nodes_pass_the_tip) {
    double low = 1.0, high = 0.0, low_of_nodes = 1.0, high_of_nodes = 0.0;
    for (int k = 0; k < 10; ++k) {
        const Shape shape(Ellipse{{}, 3.0, 2.0, 0.4}.nodes(48, 2 * pi / 48 * k / 10));
        const RadiusRange r = radius_range(shape, {});
        low = std::min(low, taylor_deformation(r.largest, r.smallest));
        high = std::max(high, taylor_deformation(r.largest, r.smallest));
        double near = 9.0, far = 0.0;
        for (int n = 0; n < 48; ++n) {
            near = std::min(near, std::hypot(shape.x[n], shape.y[n]));
            far = std::max(far, std::hypot(shape.x[n], shape.y[n]));
        }
        low_of_nodes = std::min(low_of_nodes, taylor_deformation(far, near));
        high_of_nodes = std::max(high_of_nodes, taylor_deformation(far, near));
    }
    fmt::print("jitter of D: {:.1e} by the parabola, {:.1e} by the nodes\n", high - low,
               high_of_nodes - low_of_nodes);
    EXPECT_NEAR(low, 0.2, 3e-5);
    EXPECT_LT(high - low, 3e-5);
    EXPECT_GT(high_of_nodes - low_of_nodes, 1e-3);
}

TEST(Outline, curvature_of_a_circle_of_nodes_and_its_normal_are_those_of_the_circle) {
    const Shape circle(Ellipse{{2.0, 1.0}, 4.0, 4.0, 0.0}.nodes(40));
    for (int k : {0, 7, 39}) {
        // The inscribed circle of the polygon, radius 4 cos(π/40), touches the segments.
        EXPECT_NEAR(curvature(circle, k), 1 / (4.0 * std::cos(pi / 40)), 1e-13);
        const Vec2 n = outward_normal(circle, k);
        EXPECT_NEAR(n.x, std::cos(2 * pi * k / 40), 1e-13);
        EXPECT_NEAR(n.y, std::sin(2 * pi * k / 40), 1e-13);
    }
}

TEST(Outline, centroid_velocity_is_the_derivative_of_the_centroid) {
    const Shape shape(Ellipse{{50.0, 20.0}, 3.0, 2.0, 0.4}.nodes(30));
    std::vector<double> ux, uy;
    for (int k = 0; k < 30; ++k) {
        ux.push_back(0.3 + 0.1 * std::sin(3.0 * k));
        uy.push_back(-0.1 + 0.2 * std::cos(5.0 * k));
    }
    const double dt = 1e-5;
    Shape after = shape, before = shape;
    for (int k = 0; k < 30; ++k) {
        after.x[k] += dt * ux[k], after.y[k] += dt * uy[k];
        before.x[k] -= dt * ux[k], before.y[k] -= dt * uy[k];
    }
    const Vec2 expected = (area_moments(after).centroid - area_moments(before).centroid) / (2 * dt);
    const Vec2 v = centroid_velocity(shape, ux, uy);
    EXPECT_NEAR(v.x, expected.x, 1e-8);
    EXPECT_NEAR(v.y, expected.y, 1e-8);
}

TEST(Outline, moving_a_cell_ten_boxes_away_changes_nothing) {
    const Shape near(Ellipse{{5.0, 5.0}, 3.0, 2.0, 0.4}.nodes(48));
    Shape far = near;
    for (double& x : far.x) x += 4096.0;
    const AreaMoments a = area_moments(near), b = area_moments(far);
    EXPECT_NEAR(b.area, a.area, 1e-11);
    EXPECT_NEAR(b.centroid.x, a.centroid.x + 4096.0, 1e-11);
    EXPECT_NEAR(b.xy, a.xy, 1e-10);
    const auto in_far = lengths_inside(far), in_near = lengths_inside(near);
    ASSERT_EQ(in_far.size(), in_near.size());
    for (const auto& [row, length] : in_near) EXPECT_NEAR(in_far.at(row), length, 1e-11);
}

}  // namespace
}  // namespace tt
