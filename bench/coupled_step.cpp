#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "roof.hpp"
#include "simulation/advance.hpp"

/// The whole step of the paper's channel (cases/05-channel), everything on; with a length of n
/// channels, n times the sites and cells. Counters:
///   us         best mean of a batch of 50 steps, because neighbours on the machine only slow down
///   roof_us    best time of an update in place of what a fluid pass touches (roof.hpp), in turn
///   of_roof    their ratio: the step does much else, and its pass touches less
///   MLUPS      site updates per second in it, in millions
///   ns_site    its time per site: the scene is the same for any length, so growth is cost
/// and, of the split, the best batch mean of each pass in µs.
namespace {

using namespace tt;

constexpr int batch = 50;
constexpr int roof_pairs = 10;

struct Run {
    Model model;
    State state;
    Periodic exchange;

    Run(int channels, int threads, const std::string& precision) {
        const Case c = read_case(
            TT_CASES "/05-channel/case.toml",
            {fmt::format("domain.length={} um", 80 * channels),
             fmt::format("cells.count={}", 12 * channels), "numerics.precision=" + precision});
        model = discretise(c);
        model.threads = threads;
        state = initial_state(c, model);
        advance_by(4 * batch);
    }

    void advance_by(int steps, StepTimes* times = nullptr) {
        with_team(model.threads, [&] {
            for (int k = 0; k < steps; ++k) advance(model, state, exchange, times);
        });
    }
};

template <class Real>
void step_and_roof(benchmark::State& bench, const char* precision) {
    Run run(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(1)), precision);
    Flow<Real> arrays = roof_of<Real>(run.model.lattice);
    Best step_time, roof_time;
    for (auto _ : bench) {
        roof_time.time([&] {
            with_team(run.model.threads, [&] {
                for (int k = 0; k < roof_pairs; ++k) update_twice(arrays);
            });
        });
        bench.SetIterationTime(step_time.time([&] { run.advance_by(batch); }) / batch);
    }
    const double best = step_time.seconds() / batch;
    const double roof = roof_time.seconds() / (2 * roof_pairs);
    const double sites = static_cast<double>(run.model.lattice.nx) * run.model.lattice.ny;
    bench.counters["us"] = 1e6 * best;
    bench.counters["roof_us"] = 1e6 * roof;
    bench.counters["of_roof"] = roof / best;
    bench.counters["MLUPS"] = 1e-6 * sites / best;
    bench.counters["ns_site"] = 1e9 * best / sites;
}

void coupled_step(benchmark::State& bench, const std::string& precision) {
    if (precision == "single")
        step_and_roof<float>(bench, "single");
    else
        step_and_roof<double>(bench, "double");
}

/// What each pass of `advance` takes.
void split_step(benchmark::State& bench, const char* precision) {
    Run run(static_cast<int>(bench.range(0)), 1, precision);
    std::array<double, StepTimes::names.size()> best;
    best.fill(std::numeric_limits<double>::infinity());
    for (auto _ : bench) {
        StepTimes times;
        run.advance_by(batch, &times);
        for (std::size_t k = 0; k < best.size(); ++k)
            best[k] = std::min(best[k], times.seconds()[k]);
    }
    for (std::size_t k = 0; k < best.size(); ++k)
        bench.counters[fmt::format("{}_{}", k, StepTimes::names[k])] = 1e6 * best[k] / batch;
}

void lengths_and_threads(benchmark::internal::Benchmark* b) {
    b->UseManualTime()->Unit(benchmark::kMicrosecond)->ArgNames({"channels", "threads"});
    b->Args({1, 1})->Args({1, 2})->Args({10, 1})->Args({100, 1})->MinTime(0.05);
}

void lengths(benchmark::internal::Benchmark* b) {
    b->ArgName("channels")->Arg(1)->Arg(10)->Arg(100);
}

BENCHMARK_CAPTURE(coupled_step, double, "double")->Apply(lengths_and_threads);
BENCHMARK_CAPTURE(coupled_step, single, "single")->Apply(lengths_and_threads);
BENCHMARK_CAPTURE(split_step, double, "double")->Apply(lengths);
BENCHMARK_CAPTURE(split_step, single, "single")->Apply(lengths);

}  // namespace
