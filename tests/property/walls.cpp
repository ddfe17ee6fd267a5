#include "fluid/walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <rapidcheck.h>

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/borders.hpp"

namespace tt {
namespace {

int below(int n) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, n)); }

Loop ring(Vec2 centre, double radius, int points) {
    Loop loop;
    for (int k = 0; k < points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / points;
        loop.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return loop;
}

/// Posts anywhere, also across the ends of the box, touching or within each other.
Walls random_walls(Random& random) {
    const Lattice lattice{12 + below(30), 10 + below(20), below(2) == 0};
    Solid solid;
    solid.period_x = lattice.nx;
    if (!lattice.walls) solid.period_y = lattice.ny;
    const int posts = 1 + below(4);
    for (int n = 0; n < posts; ++n)
        solid.loops.push_back(ring({random.uniform(0, lattice.nx), random.uniform(0, lattice.ny)},
                                   random.uniform(0.3, 4.0), 3 + below(20)));
    return make_walls(solid, lattice);
}

/// A channel of uneven width from one opening to another, with a third one upwards, and perhaps a
/// post in it.
Walls random_network(Random& random) {
    const Lattice lattice{24 + below(20), 24 + below(12), false};
    const double right = lattice.nx - 2.0, top = lattice.ny - 2.0;
    const auto bent = [&](double y) { return y + random.uniform(-2.0, 2.0); };
    Solid solid;
    solid.outside = true;
    solid.loops = {{{2, 4},
                    {9, bent(4)},
                    {right, 5},
                    {right, 15},
                    {18, bent(14)},
                    {17, top},
                    {8, top},
                    {7, bent(14)},
                    {2, 13}}};
    solid.openings = {{{2, 4}, {2, 13}}, {{right, 5}, {right, 15}}, {{8, top}, {17, top}}};
    if (below(2) == 0) solid.loops.push_back(ring({12, 9}, random.uniform(0.4, 2.0), 12));
    return make_walls(solid, lattice);
}

template <class Real>
struct Scene {
    Boundaries boundaries;
    std::vector<PortFlow> ports;
    Equilibrium equilibrium;
    VectorField<Real> force;
    Relaxation<Real> relaxation;
    Populations<Real> populations;
};

template <class Real = double>
Scene<Real> random_scene() {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Scene<Real> s;
    const bool network = below(2) == 0;
    Walls walls = network ? random_network(random) : random_walls(random);
    if (network)
        s.boundaries.ports = {HeldDensity{random.uniform(-0.02, 0.02)},
                              HeldInflow{random.uniform(-0.1, 0.1)},
                              HeldDensity{random.uniform(-0.02, 0.02)}};
    if (below(2) == 0)
        for (WallLink& link : walls.links)
            link.velocity = {random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
    const Lattice lattice = walls.lattice;
    s.boundaries.walls = std::make_shared<const Walls>(std::move(walls));
    const std::array<Equilibrium, 3> equilibria{LinearEquilibrium{}, IncompressibleEquilibrium{},
                                                FullEquilibrium{}};
    s.equilibrium = equilibria[below(3)];
    s.force = VectorField<Real>(lattice);
    s.relaxation = Relaxation<Real>(lattice);
    s.populations = Populations<Real>(lattice);
    for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) {
            const double even = random.uniform(0.2, 1.9);
            s.relaxation.even(i, j) = static_cast<Real>(even);
            s.relaxation.odd(i, j) = static_cast<Real>(Trt{}.odd_rate(even));
            const double open = s.boundaries.walls->is_open(i, j) ? 1.0 : 0.0;
            s.force.x(i, j) = static_cast<Real>(open * random.uniform(-1e-2, 1e-2));
            s.force.y(i, j) = static_cast<Real>(open * random.uniform(-1e-2, 1e-2));
            for (int k = 0; k < d2q9::count; ++k)
                s.populations.set_slot(k, i, j, random.uniform(-0.02, 0.02));
        }
    return s;
}

template <class Real>
void run(Scene<Real>& s, int steps, int threads) {
    VectorField<Real> velocity(s.populations.lattice());
    Periodic exchange;
    Borders<Real> borders(*s.boundaries.walls, s.populations);
    s.ports.resize(s.boundaries.ports.size());
    with_team(threads, [&] {
        for (int step = 0; step < steps; ++step) {
            collide_and_stream(s.equilibrium, s.boundaries, {1e-4, 2e-4}, s.force, s.relaxation,
                               s.populations, velocity);
            settle(exchange, s.populations, [&] {
                return borders.apply(s.equilibrium, s.boundaries, velocity, {}, s.populations,
                                     s.ports);
            });
            team_barrier();
        }
    });
}

template <class F>
void for_each_open(const Walls& walls, F&& f) {
    for (int j = 0; j < walls.lattice.ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i)
            if (walls.is_open(i, j)) f(i, j);
}

template <class Real>
double mass_of(const Scene<Real>& s) {
    double mass = 0.0;
    for_each_open(*s.boundaries.walls, [&](int i, int j) {
        for (int k = 0; k < d2q9::count; ++k) mass += s.populations.arriving(k, i, j);
    });
    return mass;
}

template <class Real>
double worst_difference(const Scene<Real>& a, const Scene<Real>& b) {
    double worst = 0.0;
    for_each_open(*a.boundaries.walls, [&](int i, int j) {
        for (int k = 0; k < d2q9::count; ++k)
            worst = std::max(
                worst, std::abs(a.populations.arriving(k, i, j) - b.populations.arriving(k, i, j)));
    });
    return worst;
}

template <class Real>
double entered(const Scene<Real>& s) {
    double inflow = 0.0;
    for (const PortFlow& port : s.ports) inflow += port.inflow[0];
    return inflow;
}

TEST(WallPass, in_place_with_links_is_the_plain_pass_and_keeps_what_does_not_enter) {
    EXPECT_TRUE(rc::check([] {
        Scene plain = random_scene();
        Scene fast = plain;
        VectorField<> velocity(plain.populations.lattice());
        for (int step = 1; step <= 4; ++step) {
            const double before = mass_of(fast);
            run(fast, 1, 1);
            collide_and_stream_reference(plain.equilibrium, plain.boundaries, {1e-4, 2e-4},
                                         plain.force, plain.relaxation, plain.populations,
                                         velocity);
            RC_ASSERT(worst_difference(fast, plain) < 1e-14 * step);
            RC_ASSERT(std::abs(mass_of(fast) - before - entered(fast)) < 1e-13);
        }
    }));
}

template <class Real>
void expect_same_bits_on_any_threads() {
    EXPECT_TRUE(rc::check([] {
        Scene<Real> one = random_scene<Real>();
        Scene<Real> many = one;
        run(one, 3, 1);
        run(many, 3, 2 + below(2));
        RC_ASSERT(worst_difference(one, many) == 0.0);
    }));
}
TEST(WallPass, gives_the_same_bits_on_any_threads) {
    expect_same_bits_on_any_threads<double>();
    expect_same_bits_on_any_threads<float>();
}

bool parted(const Walls& walls, Vec2 a, Vec2 b) {
    return std::any_of(walls.segments.begin(), walls.segments.end(),
                       [&](const WallSegment& s) { return meeting(a, b, s) >= 0.0; });
}

/// Between two open neighbours there is no wall, or a tip that a third goes round.
TEST(Walls, nothing_passes_through_a_wall) {
    EXPECT_TRUE(rc::check([] {
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        const Walls walls = random_walls(random);
        for_each_open(walls, [&](int i, int j) {
            for (int k = 1; k < d2q9::count; ++k) {
                const int x = i + d2q9::cx[k], y = j + d2q9::cy[k];
                const Vec2 here = Lattice::position(i, j), there = Lattice::position(x, y);
                if (!walls.open(x, y) || !parted(walls, here, there)) continue;
                const auto joins = [&](int a, int b) {
                    const Vec2 third = Lattice::position(a, b);
                    return walls.open(a, b) && !parted(walls, here, third) &&
                           !parted(walls, third, there);
                };
                RC_ASSERT(k >= 5 && (joins(x, j) || joins(i, y)));
            }
        });
    }));
}

TEST(Walls, distance_is_that_to_the_nearest_wall) {
    EXPECT_TRUE(rc::check([] {
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        const Walls walls = random_walls(random);
        for_each_open(walls, [&](int i, int j) {
            double nearest = HUGE_VAL;
            if (walls.lattice.walls) nearest = std::min(j + 0.5, walls.lattice.ny - j - 0.5);
            for (const WallSegment& segment : walls.segments) {
                const Vec2 here = Lattice::position(i, j);
                nearest = std::min(nearest, norm(here - nearest_on(segment, here)));
            }
            RC_ASSERT(walls.distance(i, j) >= nearest - 1e-12);
            RC_ASSERT(walls.distance(i, j) <= nearest + 0.2);  // a segment may be passed over
        });
    }));
}

}  // namespace
}  // namespace tt
