#include <benchmark/benchmark.h>

#include <algorithm>

#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "roof.hpp"

/// The fluid pass against its roof (roof.hpp), run in turn with it. Arguments: sites along x, along
/// y, threads. Best of all repetitions, because neighbours on the machine only ever slow things
/// down:
///   MLUPS      million site updates a second
///   roof       the same for the update kernel
///   of_roof    their ratio
namespace {

using namespace tt;

template <class AnEquilibrium, class Real = double>
void fluid_pass(benchmark::State& state) {
    const Lattice lattice{static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), true};
    const int threads = static_cast<int>(state.range(2));
    const Equilibrium equilibrium = AnEquilibrium{};
    const Boundaries boundaries{-0.01, 0.01, 0.0};
    const long long sites = static_cast<long long>(lattice.nx) * lattice.ny;
    const int pairs = static_cast<int>(std::max(1LL, 80'000 / sites));
    Flow<Real> flow(lattice);
    Flow<Real> roof = roof_of<Real>(lattice);
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
BENCHMARK(fluid_pass<LinearEquilibrium, float>)->Apply(sizes);
BENCHMARK(fluid_pass<IncompressibleEquilibrium, float>)->Apply(sizes);

}  // namespace
