#include "simulation/feed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "io/archive.hpp"
#include "membrane/outline.hpp"
#include "simulation/health.hpp"
#include "simulation/rescale.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

/// A straight channel of 60 by 12 um between two ports, cells coming in at one of them.
class Feeding : public TemporaryDirectory {
protected:
    /// The flow goes along x, turned left by so many right angles.
    std::string channel(int turns = 0, const std::string& extra = {}) {
        const auto turned = [&](double x, double y) {
            for (int k = 0; k < turns; ++k) std::swap(x, y), x = -x;
            return std::pair{x, y};
        };
        std::ofstream loop(path("channel.csv"));
        for (const auto& [x, y] : {turned(0, 0), turned(60, 0), turned(60, 12), turned(0, 12)})
            loop << x << ',' << y << '\n';
        const auto [ix, iy] = turned(0, 6);
        const auto [ox, oy] = turned(60, 6);
        std::ofstream(path("case.toml")) << fmt::format(
            R"(format = 1
[geometry]
shape = "file"
file = "channel.csv"
[port.in]
at = ["{} um", "{} um"]
mean_velocity = "1 mm/s"
[port.in.feed]
hematocrit = "15 %"
[port.out]
at = ["{} um", "{} um"]
pressure = "0 Pa"
[cells]
layout = "random"
hematocrit = "10 %"
radius = "2 um"
{}
[numerics]
dx = "0.4 um"
step_tolerance = "5 %"
[time]
end = "20 ms"
)",
            ix, iy, ox, oy, extra);
        return path("case.toml");
    }
    static void run(const Model& model, State& state, std::int64_t until, int threads = 1) {
        Model with = model;
        with.threads = threads;
        Periodic exchange;
        Health health({}, state);
        run_steps(with, state, exchange, health, until, Clock::time_point::max());
    }

    /// Of both ports over so many steps, as a share of what the first holds.
    static std::pair<double, double> mean_inflows(const Model& model, State& state, int steps) {
        double in = 0.0, out = 0.0;
        for (int k = 0; k < steps; ++k) {
            run(model, state, state.step + 1);
            in += state.ports[0].mean_inflow() / steps;
            out += state.ports[1].mean_inflow() / steps;
        }
        const double held = model.feeds.front().channel->drive.target_velocity * 12.0 / 0.4 *
                            model.boundaries.walls->sampled_flow();
        return {in / held, out / held};
    }
};

std::size_t entered(const State& state) { return state.feeds.front().entered.size(); }

Vec2 middle(const Suspension& cells, int cell) {
    return area_moments(outline(cells, cell)).centroid;
}

TEST_F(Feeding, counts_every_cell_that_comes_and_goes) {
    const Case c = read_case(channel());
    const Model model = discretise(c);
    State state = initial_state(c, model, {});
    const auto start = static_cast<std::size_t>(state.cells.cell_count()) - entered(state);
    run(model, state, 4000);
    EXPECT_GT(entered(state), 5u);
    EXPECT_GT(state.departed.size(), 5u);
    EXPECT_EQ(start + entered(state),
              static_cast<std::size_t>(state.cells.cell_count()) + state.departed.size());
    std::set<std::int64_t> numbers(state.cells.id.begin(), state.cells.id.end());
    for (const Departed& d : state.departed) numbers.insert(d.id);
    EXPECT_EQ(numbers.size(), start + entered(state));
    EXPECT_EQ(*numbers.rbegin() + 1, static_cast<std::int64_t>(numbers.size()));
    for (const Departed& d : state.departed) EXPECT_EQ(d.exit, 1);
    // As much comes in as the port holds, and all of it goes out.
    const auto [in, out] = mean_inflows(model, state, 300);
    EXPECT_NEAR(in, 1.0, 3e-3);
    EXPECT_NEAR(out, -1.0, 2e-2);
}

/// In a straight channel a cell that has come in goes on as the one in the feed that led it.
TEST_F(Feeding, is_not_felt_by_the_cells) {
    const Case c = read_case(channel());
    const Model model = discretise(c);
    State state = initial_state(c, model, {});
    run(model, state, 1500);
    const Feed& feed = model.feeds.front();
    // The next to be let go is watched over one width of the channel.
    while (state.feeds.front().followers.empty()) run(model, state, state.step + 1);
    const Follower watched = state.feeds.front().followers.back();
    const auto is_led = [&] {
        const auto& followers = state.feeds.front().followers;
        return std::any_of(followers.begin(), followers.end(),
                           [&](const Follower& f) { return f.cell == watched.cell; });
    };
    while (is_led()) run(model, state, state.step + 1);
    const auto here = [&] {
        const auto& id = state.cells.id;
        return static_cast<int>(std::find(id.begin(), id.end(), watched.cell) - id.begin());
    };
    const auto off = [&] {
        const Vec2 leader = middle(state.feeds.front().state.cells, watched.leader);
        return middle(state.cells, here()) - leader -
               Vec2{static_cast<double>(feed.i - watched.turn * feed.period),
                    static_cast<double>(feed.j)};
    };
    EXPECT_LT(norm(off()), 0.02);
    const double from = middle(state.cells, here()).x;
    while (middle(state.cells, here()).x < from + 30.0) run(model, state, state.step + 10);
    std::printf("off by %.3g, %.3g sites after 30 behind the port\n", off().x, off().y);
    EXPECT_LT(std::fabs(off().y), 0.15) << "sites aside after 30 along";
    EXPECT_LT(std::fabs(off().x), 0.6) << "2 % of the way";
    const double stretch = perimeter(outline(state.cells, here())) /
                           perimeter(outline(state.feeds.front().state.cells, watched.leader));
    EXPECT_NEAR(stretch, 1.0, 2e-3);
}

TEST_F(Feeding, is_the_same_on_any_threads_and_across_a_restart) {
    const Case c = read_case(channel());
    const Model model = discretise(c);
    const State start = initial_state(c, model, {});
    State one = start, three = start, stopped = start;
    constexpr std::int64_t end = 1200;
    run(model, one, end);
    run(model, three, end, 3);
    EXPECT_EQ(state_hash(one), state_hash(three));
    std::set<std::int64_t> stops{7};
    for (const Entered& e : one.feeds.front().entered)
        for (const int more : {-1, 0, 1, 40})
            stops.insert(static_cast<std::int64_t>(e.time) + more);
    for (const std::int64_t stop : stops) {
        if (stop <= stopped.step || stop >= end) continue;
        run(model, stopped, stop);
        ArchiveWriter archive(path("state"));
        save_state(archive, stopped);
        archive.commit({}, Durability::process);
        Periodic exchange;
        stopped = load_state(ArchiveReader(path("state")), model, exchange);
    }
    run(model, stopped, end);
    ASSERT_GT(entered(one), 1u);
    EXPECT_EQ(state_hash(one), state_hash(stopped));
}

/// Whichever way the port faces.
TEST_F(Feeding, is_the_same_turned) {
    std::vector<double> flows;
    for (int turns = 0; turns < 4; ++turns) {
        const Case c = read_case(channel(turns), {"numerics.precision=double"});
        const Model model = discretise(c);
        State state = initial_state(c, model, {});
        run(model, state, 1500);
        EXPECT_GT(entered(state), 1u) << turns;
        EXPECT_NEAR(mean_inflows(model, state, 100).first, 1.0, 1e-2) << turns;
        const double held = model.feeds.front().channel->drive.target_velocity;
        flows.push_back(held);
        // Cells are carried along, at some speed between none and the largest.
        for (int cell = 0; cell < state.cells.cell_count(); ++cell) {
            Vec2 mean;
            for (int n = state.cells.first[cell]; n < state.cells.first[cell + 1]; ++n)
                mean += state.cells.velocity(n) / state.cells.node_count(cell);
            const double along = dot(mean, model.feeds.front().in);
            EXPECT_GT(along, 0.2 * held) << turns;
            EXPECT_LT(along, 1.7 * held) << turns;
        }
    }
    for (const double flow : flows) EXPECT_NEAR(flow / flows[0], 1.0, 1e-9);
}

TEST_F(Feeding, goes_on_in_another_time_step) {
    const Case c = read_case(channel());
    const Model model = discretise(c);
    State state = initial_state(c, model, {});
    run(model, state, 600);
    const double ratio = 0.5;
    const Case shorter = read_case(
        channel(), {fmt::format("numerics.dt={:.17g} us", ratio * model.scales.time * 1e6),
                    "numerics.density_scale=auto"});
    const Model after = discretise(shorter);
    const double inflow = state.ports[0].mean_inflow() / model.scales.time;
    change_time_step(after, ratio, state);
    EXPECT_EQ(state.feeds.front().state.step, state.step);
    run(after, state, state.step + 400);
    EXPECT_NEAR(state.ports[0].mean_inflow() / after.scales.time / inflow, 1.0, 0.02);
}

}  // namespace
}  // namespace tt
