#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "simulation/advance.hpp"
#include "simulation/drive.hpp"

/// The whole step of the paper's channel (cases/05-channel), everything on; with a length of n
/// channels, n times the sites and cells. Counters:
///   us         best mean of a batch of 50 steps, because neighbours on the machine only slow down
///   MLUPS      site updates per second in it, in millions
///   ns_site    its time per site: the scene is the same for any length, so growth is cost
/// and, of the split, the best batch mean of each pass in µs.
namespace {

using namespace tt;
using Seconds = std::chrono::duration<double>;

constexpr int batch = 50;

struct Run {
    Model model;
    State state;
    Periodic exchange;

    explicit Run(int channels, int threads) {
        const Case c = read_case(TT_CASES "/05-channel/case.toml",
                                 {fmt::format("domain.length={} um", 80 * channels),
                                  fmt::format("cells.count={}", 12 * channels)});
        model = discretise(c);
        model.threads = threads;
        state = initial_state(c, model);
        advance_by(4 * batch);
    }

    void advance_by(int steps) {
        with_team(model.threads, [&] {
            for (int k = 0; k < steps; ++k)
                advance(model, state, exchange, FlowKept::near_membranes);
        });
    }
};

void coupled_step(benchmark::State& bench) {
    Run run(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(1)));
    double best = std::numeric_limits<double>::infinity();
    for (auto _ : bench) {
        const auto start = std::chrono::steady_clock::now();
        run.advance_by(batch);
        const double step = Seconds(std::chrono::steady_clock::now() - start).count() / batch;
        bench.SetIterationTime(step);
        best = std::min(best, step);
    }
    const double sites = static_cast<double>(run.model.lattice.nx) * run.model.lattice.ny;
    bench.counters["us"] = 1e6 * best;
    bench.counters["MLUPS"] = 1e-6 * sites / best;
    bench.counters["ns_site"] = 1e9 * best / sites;
}

/// Times one pass after another; keeps of each the best sum over a batch.
class Laps {
public:
    explicit Laps(std::vector<std::string> names)
        : names_(std::move(names)),
          sum_(names_.size(), 0.0),
          best_(names_.size(), std::numeric_limits<double>::infinity()) {}

    void start() {
        at_ = 0;
        last_ = std::chrono::steady_clock::now();
    }
    void lap() {
        const auto now = std::chrono::steady_clock::now();
        sum_[at_++] += Seconds(now - last_).count();
        last_ = now;
    }
    void end_batch() {
        for (std::size_t k = 0; k < sum_.size(); ++k) {
            best_[k] = std::min(best_[k], sum_[k]);
            sum_[k] = 0.0;
        }
    }
    void report(benchmark::State& bench) const {
        for (std::size_t k = 0; k < best_.size(); ++k)
            bench.counters[fmt::format("{:02}_{}", k, names_[k])] = 1e6 * best_[k] / batch;
    }

private:
    std::vector<std::string> names_;
    std::vector<double> sum_, best_;
    std::size_t at_ = 0;
    std::chrono::steady_clock::time_point last_;
};

/// The passes of `advance`, in its order, with a look at the clock after each.
void split_step(benchmark::State& bench) {
    Run run(static_cast<int>(bench.range(0)), 1);
    const Model& m = run.model;
    State& s = run.state;
    Laps laps({"membrane", "contact", "dipoles", "unspread", "locate", "spread", "fold",
               "viscosity", "fluid", "settle", "fill", "interpolate", "correct"});
    for (auto _ : bench) {
        for (int k = 0; k < batch; ++k) {
            laps.start();
            VectorField& flow = drive_looks_at(s.step) ? s.velocity : s.force;
            set_membrane_forces(m.membrane, s.cells), laps.lap();
            add_pair_forces(m.contact, m.lattice, s.cells, s.contact), laps.lap();
            set_dipoles(m.jump, s.cells), laps.lap();
            unspread(s.stencils, s.force), laps.lap();
            locate(m.delta, m.lattice, s.cells, s.stencils), laps.lap();
            spread(Order::first, s.stencils, s.cells, s.force), laps.lap();
            run.exchange.fold(s.force), laps.lap();
            update_viscosity(m.viscosity, s.cells, s.interior, s.relaxation), laps.lap();
            collide_and_stream(m.equilibrium, m.boundaries, {s.drive.body_force, 0.0}, s.force,
                               s.relaxation, s.populations, flow,
                               drive_looks_at(s.step) ? nullptr : &s.stencils.near_membranes);
            laps.lap();
            settle(run.exchange, s.populations), laps.lap();
            run.exchange.fill(flow), laps.lap();
            interpolate(Order::first, s.stencils, flow, s.cells), laps.lap();
            correct_velocities(m.jump, s.cells), laps.lap();
            for (int n = 0; n < s.cells.node_count(); ++n) {
                s.cells.x[n] += s.cells.ux[n];
                s.cells.y[n] += s.cells.uy[n];
            }
            hold_flow(m, s);
            ++s.step;
        }
        laps.end_batch();
    }
    laps.report(bench);
}

BENCHMARK(coupled_step)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond)
    ->ArgNames({"channels", "threads"})
    ->Args({1, 1})
    ->Args({1, 2})
    ->Args({10, 1})
    ->Args({100, 1});
BENCHMARK(split_step)->ArgName("channels")->Arg(1)->Arg(10)->Arg(100);

}  // namespace
