#include "membrane/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tt {
namespace {

int next(const Outline& outline, int k) { return k + 1 == outline.size() ? 0 : k + 1; }
int previous(const Outline& outline, int k) { return k == 0 ? outline.size() - 1 : k - 1; }

/// Calls f(a, b) for each segment, ends relative to node 0.
template <class F>
void for_each_segment(const Outline& outline, F&& f) {
    const Vec2 origin = outline[0];
    Vec2 here;
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 there = outline[next(outline, k)] - origin;
        f(here, there);
        here = there;
    }
}

/// Value at the vertex of the parabola through (−left, before), (0, here), (right, after); `here`
/// is an extremum of the three, so the vertex lies between the neighbours.
double vertex_value(double left, double right, double before, double here, double after) {
    const double slope_left = (here - before) / left;
    const double slope_right = (after - here) / right;
    const double half_curvature = (slope_right - slope_left) / (left + right);
    const double slope = (slope_left * right + slope_right * left) / (left + right);
    if (half_curvature == 0.0) return here;
    return here - slope * slope / (4.0 * half_curvature);
}

}  // namespace

double signed_area(const Outline& outline) {
    double doubled = 0.0;
    for_each_segment(outline, [&](Vec2 a, Vec2 b) { doubled += cross(a, b); });
    return 0.5 * doubled;
}

double perimeter(const Outline& outline) {
    double sum = 0.0;
    for_each_segment(outline, [&](Vec2 a, Vec2 b) { sum += norm(b - a); });
    return sum;
}

Vec2 middle_of(const Outline& outline) {
    Vec2 sum;
    for (int k = 0; k < outline.size(); ++k) sum += outline[k];
    return sum / static_cast<double>(outline.size());
}

AreaMoments area_moments(const Outline& outline) {
    double area = 0.0;
    Vec2 first;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for_each_segment(outline, [&](Vec2 a, Vec2 b) {
        const double c = cross(a, b);  // twice the triangle (0, a, b)
        area += c / 2.0;
        first += (c / 6.0) * (a + b);
        xx += c / 12.0 * (a.x * a.x + a.x * b.x + b.x * b.x);
        yy += c / 12.0 * (a.y * a.y + a.y * b.y + b.y * b.y);
        xy += c / 24.0 * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y);
    });
    const Vec2 centroid = first / area;
    const Vec2 shift = area * centroid;
    return {area, outline[0] + centroid, xx - shift.x * centroid.x, xy - shift.x * centroid.y,
            yy - shift.y * centroid.y};
}

Vec2 centroid_velocity(const Outline& outline, std::span<const double> ux,
                       std::span<const double> uy) {
    const Vec2 origin = outline[0];
    const Vec2 drift{ux[0], uy[0]};
    double area = 0.0, area_rate = 0.0;
    Vec2 first, first_rate;
    for (int k = 0; k < outline.size(); ++k) {
        const int l = next(outline, k);
        const Vec2 a = outline[k] - origin, b = outline[l] - origin;
        const Vec2 va = Vec2{ux[k], uy[k]} - drift, vb = Vec2{ux[l], uy[l]} - drift;
        const double c = cross(a, b);
        const double c_rate = cross(va, b) + cross(a, vb);
        area += c / 2.0;
        area_rate += c_rate / 2.0;
        first += (c / 6.0) * (a + b);
        first_rate += (c_rate / 6.0) * (a + b) + (c / 6.0) * (va + vb);
    }
    return drift + (first_rate - (area_rate / area) * first) / area;
}

EquivalentEllipse equivalent_ellipse(const AreaMoments& moments) {
    const double mean = 0.5 * (moments.xx + moments.yy);
    const double difference = 0.5 * (moments.xx - moments.yy);
    const double spread = std::hypot(difference, moments.xy);
    const double major = 2.0 * std::sqrt((mean + spread) / moments.area);
    const double minor = 2.0 * std::sqrt(std::max(mean - spread, 0.0) / moments.area);
    // Below this the axis is rounding, not shape.
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * mean;
    if (spread <= rounding) return {major, minor, 0.0};
    return {major, minor, 0.5 * std::atan2(moments.xy == 0.0 ? 0.0 : moments.xy, difference)};
}

RadiusRange radius_range(const Outline& outline, Vec2 centre) {
    RadiusRange range{std::numeric_limits<double>::infinity(), 0.0};
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[previous(outline, k)] - centre;
        const Vec2 p = outline[k] - centre;
        const Vec2 b = outline[next(outline, k)] - centre;
        const double before = dot(a, a), here = dot(p, p), after = dot(b, b);
        const bool low = here <= before && here <= after;
        const bool high = here >= before && here >= after;
        double value = here;
        if (low || high) value = vertex_value(norm(p - a), norm(b - p), before, here, after);
        range.smallest = std::min(range.smallest, value);
        range.largest = std::max(range.largest, value);
    }
    return {std::sqrt(std::max(range.smallest, 0.0)), std::sqrt(range.largest)};
}

double curvature(const Outline& outline, int node) {
    const Vec2 before = outline[node] - outline[previous(outline, node)];
    const Vec2 after = outline[next(outline, node)] - outline[node];
    const double lengths = norm(before) * norm(after);
    return 2.0 * cross(before, after) / (lengths + dot(before, after)) / node_length(outline, node);
}

double turn(const Outline& outline, int node) {
    const Vec2 before = outline[node] - outline[previous(outline, node)];
    const Vec2 after = outline[next(outline, node)] - outline[node];
    return std::atan2(cross(before, after), dot(before, after));
}

SharpestBend sharpest_bend(const Outline& outline) {
    double turned = 0.0, sharpest = 0.0;
    for (int k = 0; k < outline.size(); ++k) {
        turned = std::max(turned, std::abs(turn(outline, k)));
        sharpest = std::max(sharpest, std::abs(curvature(outline, k)));
    }
    return {turned, 1.0 / sharpest};
}

Vec2 outward_normal(const Outline& outline, int node) {
    const Vec2 chord = outline[next(outline, node)] - outline[previous(outline, node)];
    return turned_right(chord) / norm(chord);
}

double node_length(const Outline& outline, int node) {
    const Vec2 here = outline[node];
    const Vec2 before = outline[previous(outline, node)], after = outline[next(outline, node)];
    return 0.5 * (norm(here - before) + norm(after - here));
}

std::vector<RowCrossing> row_crossings(const Outline& outline) {
    std::vector<RowCrossing> found;
    const auto row_below = [](double y) { return static_cast<int>(std::floor(y - 0.5)); };
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 a = outline[k], b = outline[next(outline, k)];
        const int turn = b.y > a.y ? 1 : -1;
        const int last = row_below(std::max(a.y, b.y));
        for (int row = row_below(std::min(a.y, b.y)) + 1; row <= last; ++row)
            found.push_back({row, a.x + (row + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x), turn});
    }
    return found;
}

}  // namespace tt
