#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "base/isa.hpp"
#include "base/random.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"

/// The fluid pass against its roof: an update in place of the same arrays (nine planes read and
/// written, force and rates read, velocity written) with next to no arithmetic, run in turn with
/// it. Arguments: sites along x, along y, threads. Best of all repetitions, because neighbours on
/// the machine only ever slow things down:
///   MLUPS      million site updates a second
///   roof       the same for the update kernel
///   of_roof    their ratio
namespace {

using namespace tt;

struct Flow {
    VectorField force;
    VectorField velocity;
    Relaxation relaxation;
    Populations populations;

    explicit Flow(const Lattice& lattice, Precision precision)
        : force(lattice), velocity(lattice), relaxation(lattice), populations(lattice, precision) {
        Random random(1);
        for (int j = 0; j < lattice.ny; ++j) {
            for (int i = 0; i < lattice.nx; ++i) {
                force.x(i, j) = random.uniform(-1e-5, 1e-5);
                force.y(i, j) = random.uniform(-1e-5, 1e-5);
                relaxation.even(i, j) = random.uniform(0.5, 1.5);
                relaxation.odd(i, j) = Trt{}.odd_rate(relaxation.even(i, j));
            }
        }
    }
};

template <class Real>
struct RowOfArrays {
    Real* plane[d2q9::count];
    const double *force_x, *force_y, *even, *odd;
    double *velocity_x, *velocity_y;
};

template <class Real>
TT_INLINE void update(const RowOfArrays<Real>& row, int count) {
    const auto [p0, p1, p2, p3, p4, p5, p6, p7, p8] = row.plane;
    const auto [plane, force_x, force_y, even, odd, velocity_x, velocity_y] = row;
    const auto scale = [](Real& f, double by) { f = static_cast<Real>(f * by); };
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const double a = even[i];
        const double b = odd[i];
        velocity_x[i] = a * force_x[i];
        velocity_y[i] = b * force_y[i];
        scale(p0[i], a), scale(p1[i], b), scale(p2[i], a), scale(p3[i], b), scale(p4[i], a);
        scale(p5[i], b), scale(p6[i], a), scale(p7[i], b), scale(p8[i], a);
    }
}

TT_CLONES void update_row(const RowOfArrays<double>& row, int count) { update(row, count); }
TT_CLONES void update_row(const RowOfArrays<float>& row, int count) { update(row, count); }

/// Two updates of everything the pass touches.
void update_twice(Flow& flow) {
    const Lattice& lattice = flow.populations.lattice();
    const auto [begin, end] = team_share(lattice.ny);
    for (int pass = 0; pass < 2; ++pass) {
        flow.populations.visit([&]<class Real>(Real* numbers) {
            for (int j = begin; j < end; ++j) {
                RowOfArrays<Real> row{{},
                                      flow.force.x.row(j),
                                      flow.force.y.row(j),
                                      flow.relaxation.even.row(j),
                                      flow.relaxation.odd.row(j),
                                      flow.velocity.x.row(j),
                                      flow.velocity.y.row(j)};
                for (int k = 0; k < d2q9::count; ++k)
                    row.plane[k] = numbers + flow.populations.row(k, j);
                update_row(row, lattice.nx);
            }
        });
        team_barrier();
    }
}

/// Seconds of the fastest of the repetitions of `f` seen so far.
class Best {
public:
    template <class F>
    double time(F&& f) {
        const auto start = std::chrono::steady_clock::now();
        f();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        seconds_ = std::min(seconds_, elapsed.count());
        return elapsed.count();
    }
    double seconds() const { return seconds_; }

private:
    double seconds_ = 1e300;
};

template <class AnEquilibrium, Precision precision = Precision::fp64>
void fluid_pass(benchmark::State& state) {
    const Lattice lattice{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), true};
    const int threads = static_cast<int>(state.range(2));
    const Equilibrium equilibrium = AnEquilibrium{};
    const Boundaries boundaries{-0.01, 0.01, 0.0};
    const long long sites = static_cast<long long>(lattice.nx) * lattice.ny;
    const int pairs = static_cast<int>(std::max(1LL, 80'000 / sites));
    Flow flow(lattice, precision);
    Flow roof(lattice, precision);
    roof.relaxation = Relaxation(lattice);  // rates of one: values stay as they are
    Periodic exchange;
    Best pass_time;
    Best roof_time;
    for (auto _ : state) {
        roof_time.time([&] {
            with_team(threads, [&] {
                for (int n = 0; n < pairs; ++n) update_twice(roof);
            });
        });
        state.SetIterationTime(pass_time.time([&] {
            with_team(threads, [&] {
                for (int n = 0; n < 2 * pairs; ++n) {
                    collide_and_stream(equilibrium, boundaries, {1e-6, 0.0}, flow.force,
                                       flow.relaxation, flow.populations, flow.velocity);
                    settle(exchange, flow.populations);
                }
            });
        }));
    }
    const double updates = 2e-6 * static_cast<double>(pairs) * static_cast<double>(sites);
    state.counters["MLUPS"] = updates / pass_time.seconds();
    state.counters["roof"] = updates / roof_time.seconds();
    state.counters["of_roof"] = roof_time.seconds() / pass_time.seconds();
}

void sizes(benchmark::internal::Benchmark* b) {
    b->UseManualTime()->Unit(benchmark::kMillisecond)->ArgNames({"nx", "ny", "threads"});
    for (const int threads : {1, 2}) {
        b->Args({400, 100, threads});
        b->Args({4000, 1000, threads});
    }
    b->Args({200, 20, 1});  // fits the second-level cache of most machines
}

BENCHMARK(fluid_pass<LinearEquilibrium>)->Apply(sizes);
BENCHMARK(fluid_pass<IncompressibleEquilibrium>)->Apply(sizes);
BENCHMARK(fluid_pass<FullEquilibrium>)->Apply(sizes);
BENCHMARK(fluid_pass<LinearEquilibrium, Precision::fp32>)->Apply(sizes);
BENCHMARK(fluid_pass<IncompressibleEquilibrium, Precision::fp32>)->Apply(sizes);

}  // namespace
