#pragma once

#include <span>
#include <vector>

#include "membrane/suspension.hpp"

namespace tt {

/// The geometry of one cell's outline, in the unit of its nodes. Areas and moments are those of the
/// polygon, exact but for rounding; the polygon itself lies inside a convex outline, so that N
/// nodes on a circle of radius a enclose π a² (1 − 2π²/(3N²) + …): everything here is second order
/// in the segment length against the smooth outline (tests/unit/outline.cpp prints the orders).
/// Nothing depends on where the outline stands or at which node it starts, but for rounding: sums
/// are taken relative to node 0, however far the cell has travelled.

/// Signed area ½ ∮ x dy − y dx (Eq. 15; as printed it lacks the ½), positive counter-clockwise.
double signed_area(const Outline& outline);

/// Sum of the segment lengths, L_C.
double perimeter(const Outline& outline);

/// Mean of the nodes.
Vec2 middle_of(const Outline& outline);

/// Area, centroid of the area, and central second moments ∫ (x − x_c)² dA and so on, exact for the
/// polygon.
struct AreaMoments {
    double area = 0.0;
    Vec2 centroid;
    double xx = 0.0, xy = 0.0, yy = 0.0;
};
AreaMoments area_moments(const Outline& outline);

/// Velocity of the area's centroid when the nodes move with (ux, uy): the exact time derivative of
/// the polygon's centroid.
Vec2 centroid_velocity(const Outline& outline, std::span<const double> ux,
                       std::span<const double> uy);

/// The ellipse with the same ratio of second moments to area, xx/A = a²/4 along its axes; for an
/// ellipse it is the ellipse itself. `inclination` is that of the long axis to x, in (−π/2, π/2],
/// and 0 where the moments have no preferred axis.
struct EquivalentEllipse {
    double major = 0.0;  ///< semi-axis
    double minor = 0.0;
    double inclination = 0.0;
};
EquivalentEllipse equivalent_ellipse(const AreaMoments& moments);

/// Smallest and largest distance of the outline from `centre`: extrema of the parabola of r² over
/// arc length through each node that is an extremum and its two neighbours. Fourth order at the
/// tips of an ellipse, third where the outline is not symmetric about the extremum; the largest
/// *node* distance would be second order and jitter as nodes pass the tip.
struct RadiusRange {
    double smallest = 0.0;
    double largest = 0.0;
};
RadiusRange radius_range(const Outline& outline, Vec2 centre);

/// (L − B)/(L + B) of two diameters or radii (Eq. 18), 0 for a circle.
constexpr double taylor_deformation(double length, double breadth) {
    return (length - breadth) / (length + breadth);
}

/// Curvature at node k, positive where convex: turning 2 tan(θ/2) over half the length of the two
/// segments. Second order for evenly spaced nodes; exact on a regular polygon's inscribed circle.
double curvature(const Outline& outline, int node);

/// Turn from the segment before node k to the one after it, in [−π, π], positive where convex.
double turn(const Outline& outline, int node);

/// How sharply the outline bends at the most: what a grid must resolve.
struct SharpestBend {
    double turn = 0.0;    ///< largest |turn|
    double radius = 0.0;  ///< smallest radius of curvature
};
SharpestBend sharpest_bend(const Outline& outline);

/// Unit outward normal at node k, perpendicular to the chord between its neighbours.
Vec2 outward_normal(const Outline& outline, int node);

/// Half the length of the two segments that meet at node k: the node's share of the perimeter.
double node_length(const Outline& outline, int node);

/// A place where an outline crosses the line through a row of sites, y = row + ½.
struct RowCrossing {
    int row;
    double x;
    int turn;  ///< +1 upwards, −1 downwards: the right and the left side
};

/// All of them, in the order of the nodes. A node on a line counts as above it, so that each line
/// is crossed as often upwards as downwards; Σ turn x is the length of the line that lies inside,
/// overlapping folds counted by their winding number. Exact for the polygon.
std::vector<RowCrossing> row_crossings(const Outline& outline);

}  // namespace tt
