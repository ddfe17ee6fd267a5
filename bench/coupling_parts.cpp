#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "base/random.hpp"
#include "coupling/viscosity.hpp"
#include "interaction/contact.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/shapes.hpp"

/// The passes between membranes and lattice that are not the fluid's: viscosity field, contact,
/// overlaps. Twelve cells of 126 nodes and radius 20 on 400 × 100 sites, as in the paper's channel,
/// for each argument `channels` side by side. The cells move by about 0.02 sites a step. Processor
/// time of one thread. Counters:
///   ns_node    per node and step; the µs of a step with 12 cells are the time column
///   pairs      node–cell pairs within range, per node
namespace {

using namespace tt;

struct Scene {
    Lattice lattice;
    Suspension cells;
    double speed;

    explicit Scene(int channels, double sites_per_step = 0.02)
        : lattice{400 * channels, 100, true}, speed(sites_per_step) {
        Random random(3);
        for (int n = 0; n < 12 * channels; ++n) {
            const int column = n / 2;
            const double squeeze = random.uniform(0.95, 1.15);
            const Vec2 centre{
                400.0 / 6.0 * (column + 0.5 + 0.25 * (n % 2)) + random.uniform(-2.5, 2.5),
                (n % 2 == 0 ? 26.0 : 74.0) + random.uniform(-2.5, 2.5)};
            add_cell(cells, placed(ellipse(20.0 * squeeze, 20.0 / squeeze, 126),
                                   random.uniform(0.0, 3.0), centre));
        }
    }

    /// All drift with the flow at `speed`, the two rows sway against each other at up to half of it
    /// and every cell across the channel at a fifth: the scene stays what it is for any number of
    /// steps.
    void move(int step) {
        const double sway = 0.5 * speed * std::cos(0.03 * step);
        for (int c = 0; c < cells.cell_count(); ++c) {
            const Vec2 v{speed + (c % 2 == 0 ? sway : -sway),
                         0.2 * speed * std::cos(0.02 * step + c)};
            for (int k = cells.first[c]; k < cells.first[c + 1]; ++k) {
                cells.x[k] += v.x;
                cells.y[k] += v.y;
            }
        }
    }
};

/// Processor time of this thread: what neighbours on the machine take away is not counted.
double now() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Runs `pass` once per moved step and counts its time alone.
template <class Pass>
void run(benchmark::State& state, Scene& scene, Pass&& pass) {
    int step = 0;
    double total = 0.0;
    for (auto _ : state) {
        scene.move(step++);
        const double start = now();
        pass();
        const double seconds = now() - start;
        state.SetIterationTime(seconds);
        total += seconds;
    }
    state.counters["ns_node"] = 1e9 * total / step / scene.cells.node_count();
}

void update_viscosity_with(benchmark::State& state, InterfaceViscosity interface,
                           double refresh_distance) {
    Scene scene(static_cast<int>(state.range(0)));
    ViscosityModel model;
    model.interface = interface;
    model.cytoplasm = 5.0 * model.plasma;
    model.refresh_distance = refresh_distance;
    InteriorState interior;
    Relaxation relaxation(scene.lattice);
    rebuild_viscosity(model, scene.cells, interior, relaxation);
    run(state, scene, [&] {
        lay_cytoplasm(model, scene.cells, interior);
        update_viscosity(model, interior, relaxation);
    });
}

void pair_forces(benchmark::State& state) {
    Scene scene(static_cast<int>(state.range(0)));
    ContactModel model;
    model.law = Morse{1e-3, 0.77, 2.45, true};
    model.range = 12.0;
    ContactState contact;
    run(state, scene, [&] { add_pair_forces(model, scene.lattice, 0, scene.cells, contact); });
    double hits = 0.0;
    for (const CellContacts& c : contact.cells) hits += static_cast<double>(c.hits.count);
    state.counters["pairs"] = hits / scene.cells.node_count();
}

void overlaps(benchmark::State& state) {
    Scene scene(static_cast<int>(state.range(0)));
    run(state, scene, [&] { benchmark::DoNotOptimize(find_overlaps(scene.lattice, scene.cells)); });
}

void self_crossings(benchmark::State& state) {
    Scene scene(static_cast<int>(state.range(0)));
    run(state, scene, [&] {
        for (int c = 0; c < scene.cells.cell_count(); ++c)
            benchmark::DoNotOptimize(self_crossing(outline(scene.cells, c)));
    });
}

#define TT_BENCH_CHANNELS Unit(benchmark::kMicrosecond)->UseManualTime()->Arg(1)->Arg(10)->Arg(100)
BENCHMARK_CAPTURE(update_viscosity_with, sharp_every_step, SharpInterface{}, 0.0)
    ->TT_BENCH_CHANNELS;
BENCHMARK_CAPTURE(update_viscosity_with, smoothed_every_step, SmoothedInterface{2.0}, 0.0)
    ->TT_BENCH_CHANNELS;
BENCHMARK_CAPTURE(update_viscosity_with, area_fraction_every_step, AreaFraction{}, 0.0)
    ->TT_BENCH_CHANNELS;
BENCHMARK_CAPTURE(update_viscosity_with, sharp, SharpInterface{}, 0.05)->TT_BENCH_CHANNELS;
BENCHMARK_CAPTURE(update_viscosity_with, smoothed, SmoothedInterface{2.0}, 0.05)->TT_BENCH_CHANNELS;
BENCHMARK_CAPTURE(update_viscosity_with, area_fraction, AreaFraction{}, 0.05)->TT_BENCH_CHANNELS;
BENCHMARK(pair_forces)->TT_BENCH_CHANNELS;
BENCHMARK(overlaps)->TT_BENCH_CHANNELS;
BENCHMARK(self_crossings)->TT_BENCH_CHANNELS;

}  // namespace
