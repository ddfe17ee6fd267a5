#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <rapidcheck.h>

#include "base/random.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"

namespace {

using namespace tt;

/// Everything a pass depends on, drawn at random.
template <class Real = double>
struct Scene {
    Lattice lattice;
    Equilibrium equilibrium;
    Boundaries boundaries;
    Vec2 body_force;
    VectorField<Real> force;
    Relaxation<Real> relaxation;
    Populations<Real> populations;
};

const std::array<Equilibrium, 3> equilibria{LinearEquilibrium{}, IncompressibleEquilibrium{},
                                            FullEquilibrium{}};
const std::array<Collision, 2> collisions{Trt{}, Bgk{}};

int below(int n) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, n)); }

Lattice random_lattice() { return {1 + below(37), 1 + below(12), below(2) == 0}; }

template <class Real = double>
Scene<Real> random_scene(const Lattice& lattice = random_lattice()) {
    Scene<Real> s;
    s.lattice = lattice;
    s.equilibrium = equilibria[below(3)];
    const Collision collision = collisions[below(2)];
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    if (below(2) == 0) s.boundaries.bottom_speed = random.uniform(-0.1, 0.1);
    if (below(2) == 0) s.boundaries.top_speed = random.uniform(-0.1, 0.1);
    if (below(2) == 0) s.boundaries.pressure_drop = random.uniform(-0.01, 0.01);
    s.body_force = {random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3)};
    s.force = VectorField<Real>(s.lattice);
    s.relaxation = Relaxation<Real>(s.lattice);
    s.populations = Populations<Real>(s.lattice);
    for (int j = 0; j < s.lattice.ny; ++j) {
        for (int i = 0; i < s.lattice.nx; ++i) {
            s.force.x(i, j) = static_cast<Real>(random.uniform(-1e-2, 1e-2));
            s.force.y(i, j) = static_cast<Real>(random.uniform(-1e-2, 1e-2));
            const double even = random.uniform(0.2, 1.9);
            s.relaxation.even(i, j) = static_cast<Real>(even);
            s.relaxation.odd(i, j) =
                static_cast<Real>(std::visit([&](auto c) { return c.odd_rate(even); }, collision));
            for (int k = 0; k < d2q9::count; ++k)
                s.populations.set_slot(k, i, j, random.uniform(-0.02, 0.02));
        }
    }
    return s;
}

/// `steps` passes of the fast kernel on `threads` threads. Returns the velocity of the last.
template <class Real>
VectorField<Real> run(Scene<Real>& s, int steps, int threads) {
    VectorField<Real> velocity(s.lattice);
    Periodic exchange;
    with_team(threads, [&] {
        for (int step = 0; step < steps; ++step) {
            collide_and_stream(s.equilibrium, s.boundaries, s.body_force, s.force, s.relaxation,
                               s.populations, velocity);
            settle(exchange, s.populations);
            team_barrier();
        }
    });
    return velocity;
}

template <class Real>
VectorField<Real> run_reference(Scene<Real>& s, int steps) {
    VectorField<Real> velocity(s.lattice);
    for (int step = 0; step < steps; ++step) {
        collide_and_stream_reference(s.equilibrium, s.boundaries, s.body_force, s.force,
                                     s.relaxation, s.populations, velocity);
    }
    return velocity;
}

template <class F>
void for_each_site(const Lattice& lattice, F&& f) {
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) f(i, j);
    }
}

template <class Real>
double worst_difference(const Populations<Real>& a, const Populations<Real>& b) {
    double worst = 0.0;
    for_each_site(a.lattice(), [&](int i, int j) {
        for (int k = 0; k < d2q9::count; ++k) {
            worst = std::max(worst, std::abs(a.arriving(k, i, j) - b.arriving(k, i, j)));
        }
    });
    return worst;
}

TEST(FluidPass, velocity_may_take_the_place_of_the_force) {
    EXPECT_TRUE(rc::check([] {
        Scene apart = random_scene();
        Scene together = apart;
        const VectorField<> force = apart.force;
        VectorField<> velocity(apart.lattice);
        Periodic exchange;
        for (int step = 0; step < 3; ++step) {
            together.force = force;
            collide_and_stream(apart.equilibrium, apart.boundaries, apart.body_force, force,
                               apart.relaxation, apart.populations, velocity);
            collide_and_stream(together.equilibrium, together.boundaries, together.body_force,
                               together.force, together.relaxation, together.populations,
                               together.force);
            settle(exchange, apart.populations);
            settle(exchange, together.populations);
        }
        RC_ASSERT(apart.populations == together.populations);
        for_each_site(apart.lattice,
                      [&](int i, int j) { RC_ASSERT(together.force(i, j) == velocity(i, j)); });
    }));
}

TEST(FluidPass, fast_and_reference_pass_agree_to_rounding) {
    for (const Equilibrium& equilibrium : equilibria) {
        EXPECT_TRUE(rc::check([&] {
            Scene fast = random_scene();
            fast.equilibrium = equilibrium;
            Scene plain = fast;
            const int steps = 1 + below(5);
            const VectorField u = run(fast, steps, 1);
            const VectorField v = run_reference(plain, steps);
            double worst = worst_difference(fast.populations, plain.populations);
            for_each_site(fast.lattice,
                          [&](int i, int j) { worst = std::max(worst, norm(u(i, j) - v(i, j))); });
            RC_LOG() << "worst difference " << worst << '\n';
            RC_ASSERT(worst < 2e-15);
        }));
    }
}

TEST(FluidPass, fast_and_reference_pass_agree_to_rounding_in_single_precision) {
    // A few roundings a step, relative 6e-8, of populations up to a tenth.
    constexpr double rounding = 0x1p-24;
    for (const Equilibrium& equilibrium : equilibria) {
        EXPECT_TRUE(rc::check([&] {
            Scene<float> fast = random_scene<float>();
            fast.equilibrium = equilibrium;
            Scene plain = fast;
            const int steps = 1 + below(5);
            const VectorField u = run(fast, steps, 1 + below(3));
            const VectorField v = run_reference(plain, steps);
            double worst = worst_difference(fast.populations, plain.populations);
            for_each_site(fast.lattice,
                          [&](int i, int j) { worst = std::max(worst, norm(u(i, j) - v(i, j))); });
            RC_LOG() << "worst difference " << worst << '\n';
            RC_ASSERT(worst < rounding);
        }));
    }
}

TEST(FluidPass, takes_over_from_the_reference_pass_in_either_phase) {
    EXPECT_TRUE(rc::check([] {
        Scene mixed = random_scene();
        Scene plain = mixed;
        run(mixed, *rc::gen::element(1, 2), 1);
        run_reference(plain, mixed.populations.phase == Phase::odd ? 1 : 2);
        run_reference(mixed, 1);
        run_reference(plain, 1);
        RC_ASSERT(worst_difference(mixed.populations, plain.populations) < 2e-15);
    }));
}

TEST(FluidPass, gives_the_same_bits_on_1_to_8_threads) {
    EXPECT_TRUE(rc::check([] {
        Scene alone = random_scene();
        Scene team = alone;
        const VectorField u = run(alone, 3, 1);
        const VectorField v = run(team, 3, *rc::gen::inRange(2, 9));
        RC_ASSERT(alone.populations == team.populations);
        RC_ASSERT(std::memcmp(u.x.data(), v.x.data(), u.x.size() * sizeof(double)) == 0);
        RC_ASSERT(std::memcmp(u.y.data(), v.y.data(), u.y.size() * sizeof(double)) == 0);
    }));
}

TEST(FluidPass, conserves_mass_at_any_wall_and_end) {
    EXPECT_TRUE(rc::check([] {
        Scene s = random_scene();
        const auto mass = [&] {
            double sum = 0.0;
            for_each_site(s.lattice, [&](int i, int j) {
                sum += moments(s.populations, i, j).density_deviation;
            });
            return sum;
        };
        const double before = mass();
        run(s, *rc::gen::inRange(1, 12), 1);
        RC_ASSERT(std::abs(mass() - before) < 1e-12);
    }));
}

TEST(FluidPass, momentum_in_a_periodic_box_grows_by_the_sum_of_the_forces) {
    EXPECT_TRUE(rc::check([] {
        Lattice periodic = random_lattice();
        periodic.walls = false;
        Scene s = random_scene(periodic);
        s.boundaries.pressure_drop = 0.0;
        const auto momentum = [&] {
            Vec2 sum;
            for_each_site(s.lattice,
                          [&](int i, int j) { sum += moments(s.populations, i, j).momentum; });
            return sum;
        };
        Vec2 expected = momentum();
        const int steps = *rc::gen::inRange(1, 8);
        for_each_site(s.lattice, [&](int i, int j) {
            expected += double(steps) * (s.force(i, j) + s.body_force);
        });
        run(s, steps, 1);
        RC_ASSERT(norm(momentum() - expected) < 1e-12);
    }));
}

TEST(FluidPass, a_copy_of_populations_is_a_run_of_its_own) {
    EXPECT_TRUE(rc::check([] {
        Scene s = random_scene();
        Scene copy = s;
        const Scene kept = s;
        run(copy, 2, 1);
        RC_ASSERT(s.populations == kept.populations);
        Scene assigned = kept;
        assigned.populations = copy.populations;
        RC_ASSERT(assigned.populations.slot(1, 0, 0) == copy.populations.slot(1, 0, 0));
        assigned.populations.set_slot(1, 0, 0, 1.0);
        RC_ASSERT(assigned.populations.slot(1, 0, 0) != copy.populations.slot(1, 0, 0));
    }));
}

}  // namespace
