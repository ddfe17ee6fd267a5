#pragma once

#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// Stress-free outlines about the origin, counter-clockwise, nodes at equal arc length. Any unit of
/// length.

/// Circle of the radius given; nodes on the circle.
std::vector<Vec2> circle(double radius, int nodes);

/// Ellipse of semi-axes `major` (along x) and `minor`.
std::vector<Vec2> ellipse(double major, double minor, int nodes);

/// Biconcave section of a resting red cell (Evans and Fung 1972; long axis along x), R₀ its half
/// length: y = ± (R₀/2) √(1 − x²) (0.207161 + 2.002558 x² − 1.122762 x⁴), x in units of R₀. R₀
/// = 3.91 µm: area 13.63 µm², perimeter 19.27 µm.
std::vector<Vec2> biconcave(double half_length, int nodes);

/// Nodes at equal arc length along the closed polygon `curve`, starting at its first point.
std::vector<Vec2> at_equal_arc_length(const std::vector<Vec2>& curve, int nodes);

/// Length of the closed polygon.
double perimeter_of(const std::vector<Vec2>& curve);

/// Enclosed area of the closed polygon, positive if counter-clockwise.
double area_of(const std::vector<Vec2>& curve);

/// Centroid of the enclosed area, exact for the polygon. Precondition: the area is not zero.
Vec2 centroid_of(const std::vector<Vec2>& curve);

/// The closed polygon with its corners rounded: mean of the points along it, weighted by a Gaussian
/// of standard deviation `length` in arc length, then scaled about its centroid to the same area. A
/// wave of length l along the outline keeps e^{−2 (π length/l)²} of its height.
std::vector<Vec2> smoothed(const std::vector<Vec2>& curve, double length);

/// The polygon turned counter-clockwise by `angle` [rad] and moved by `shift`.
std::vector<Vec2> placed(std::vector<Vec2> curve, double angle, Vec2 shift);

}  // namespace tt
