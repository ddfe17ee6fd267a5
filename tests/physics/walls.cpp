#include "fluid/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flow.hpp"

namespace tt {
namespace {

constexpr double pi = std::numbers::pi;

Loop circle_of(Vec2 centre, double radius) {
    Loop loop;
    const int points = 720;
    // Of the same area as the circle.
    const double corner = radius * std::sqrt(2.0 * pi / points / std::sin(2.0 * pi / points));
    for (int k = 0; k < points; ++k) {
        const double angle = 2.0 * pi * k / points;
        loop.push_back(centre + corner * Vec2{std::cos(angle), std::sin(angle)});
    }
    return loop;
}

Flow flow_with(const Walls& walls, double tau) {
    Flow flow(walls.lattice);
    flow.boundaries.walls = std::make_shared<const Walls>(walls);
    flow.set_viscosity([&](int) { return (tau - 0.5) / 3.0; });
    return flow;
}

/// The mean of two steps: what a lattice conserves besides momentum changes sign from one to the
/// next.
VectorField<> steady(Flow& flow, long long steps) {
    flow.run(steps);
    VectorField<> mean = flow.velocity;
    flow.run(1);
    for (std::size_t n = 0; n < mean.x.size(); ++n) {
        mean.x.data()[n] = 0.5 * (mean.x.data()[n] + flow.velocity.x.data()[n]);
        mean.y.data()[n] = 0.5 * (mean.y.data()[n] + flow.velocity.y.data()[n]);
    }
    return mean;
}

/// L2 error of the flow between a turning outer ring and a resting inner one of half its radius.
double couette_error(double outer, double tau) {
    const int size = 2 * static_cast<int>(outer) + 6;
    const double inner = 0.5 * outer;
    const Vec2 centre{0.5 * size + 0.13, 0.5 * size - 0.21};
    Solid solid;
    solid.outside = true;
    solid.loops = {circle_of(centre, outer), circle_of(centre, inner)};
    Walls walls = make_walls(solid, Lattice{size, size, false});
    const double spin = 0.02 / outer;
    for (WallLink& link : walls.links) {
        const Vec2 at = Lattice::position(link.i, link.j) -
                        link.q * Vec2{double(d2q9::cx[link.direction]),
                                      double(d2q9::cy[link.direction])} -
                        centre;
        if (link.loop == 0) link.velocity = spin * Vec2{-at.y, at.x};
    }
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0;
    const VectorField<> u = steady(flow, 500 + static_cast<long long>(3.0 * outer * outer / viscosity));
    const double a = spin * outer * outer / (outer * outer - inner * inner);
    double error = 0.0, total = 0.0;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            if (!walls.is_open(i, j)) continue;
            const Vec2 r = Lattice::position(i, j) - centre;
            const double turn = a * (1.0 - inner * inner / dot(r, r));
            const Vec2 exact = turn * Vec2{-r.y, r.x};
            const Vec2 off = u(i, j) - exact;
            error += dot(off, off);
            total += dot(exact, exact);
        }
    return std::sqrt(error / total);
}

TEST(Walls, circular_couette_flow_is_second_order_at_any_relaxation_time) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        const double coarse = couette_error(10.0, tau), fine = couette_error(20.0, tau);
        EXPECT_LT(fine, 3e-3) << tau;
        EXPECT_GT(std::log2(coarse / fine), 1.9) << coarse << " " << fine;
    }
}

/// A channel that climbs by `rise` over the `length` of its period: a box of `length` columns and
/// `rise` rows is periodic both ways, and holds as many pieces of the channel as fit one above the
/// other. Flow rate over the exact one, less 1.
double inclined_error(int length, int rise, double height, double offset, double tau) {
    const double secant = std::hypot(length, rise) / length;
    const double half = 0.5 * height * secant;  // along y
    // Rows: a multiple of the rise with room for the channel and a wall of some sites.
    const int turns = static_cast<int>(std::ceil((2.0 * half + 8.0) / rise));
    const int ny = turns * rise;
    Solid solid;
    solid.outside = true;
    solid.period_x = length * turns;
    solid.period_y = ny;
    const double far = length * turns;
    const auto middle = [&](double x) { return offset + x * rise / length; };
    solid.loops = {{{0.0, middle(0.0) - half},
                    {far, middle(far) - half},
                    {far, middle(far) + half},
                    {0.0, middle(0.0) + half}}};
    const Walls walls = make_walls(solid, Lattice{length * turns, ny, false});
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0, force = 1e-6;
    flow.body_force = force / secant * Vec2{1.0, static_cast<double>(rise) / length};
    const VectorField<> u =
        steady(flow, 1000 + static_cast<long long>(3.0 * height * height / viscosity));
    // Along the channel, over all of its length; every column holds one period's worth of it.
    double sum = 0.0;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i)
            sum += (u.x(i, j) + u.y(i, j) * rise / length) / secant;
    const double flux = sum / (walls.lattice.nx * secant);
    return flux / (force * height * height * height / (12.0 * viscosity)) - 1.0;
}

TEST(Walls, flow_in_inclined_channels) {
    struct Slope {
        int length, rise;
    };
    for (const Slope slope : {Slope{5, 1}, Slope{3, 1}, Slope{2, 1}, Slope{1, 1}}) {
        for (const double offset : {0.0, 0.37}) {
            const double usual = inclined_error(slope.length, slope.rise, 20.0, offset, 1.5);
            EXPECT_LT(std::abs(usual), 0.003) << slope.length << " " << offset;
            for (const double tau : {0.6, 5.5})
                EXPECT_NEAR(inclined_error(slope.length, slope.rise, 20.0, offset, tau), usual, 1e-3)
                    << tau;
        }
    }
}

/// K of Darcy's law for a square array of posts of this radius, times viscosity over force, against
/// drag: F/(μ U) = L²/K.
double array_drag(int size, double share, double tau) {
    Solid solid;
    const double radius = size * std::sqrt(share / pi);
    solid.loops = {circle_of({0.31, 0.27}, radius)};
    solid.period_x = solid.period_y = size;
    const Walls walls = make_walls(solid, Lattice{size, size, false});
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0, force = 1e-6;
    flow.body_force = {force, 0.0};
    const VectorField<> u = steady(flow, static_cast<long long>(size * size / viscosity));
    // The mean flux of all columns, with what the walls' places between sites leave out.
    double sum = 0.0;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) sum += u.x(i, j);
    const double mean = sum / (size * size);
    return force * size * size / (viscosity * mean);
}

/// F/(μ U) of Sangani and Acrivos (1982); confirmed by finite elements, see
/// tests/reference/stokes_networks.csv.
TEST(Walls, drag_of_square_arrays_of_posts) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        EXPECT_NEAR(array_drag(40, 0.2, tau) / 51.527, 1.0, 0.005) << tau;
        EXPECT_NEAR(array_drag(40, 0.5, tau) / 532.55, 1.0, 0.005) << tau;
    }
}

}  // namespace
}  // namespace tt
