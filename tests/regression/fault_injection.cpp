#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "io/archive.hpp"
#include "io/frames.hpp"
#include "io/json.hpp"
#include "report/failure_section.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Lets a run go wrong at a step of one's choice: the exchange is the one thing that a step calls
/// and that is ours to give.
class FaultyExchange : public Periodic {
public:
    using Fault = std::function<void(State&)>;
    FaultyExchange(State& state, std::int64_t step, Fault fault)
        : state_(state), step_(step), fault_(std::move(fault)) {}

    using Periodic::fill;
    using Periodic::fold;
    /// After the membrane forces have been spread, before the fluid's pass.
    void fold(VectorField<>& field) override {
        Periodic::fold(field);
        on_one_thread([&] {
            if (state_.step == step_) fault_(state_);
        });
    }

private:
    State& state_;
    std::int64_t step_;
    Fault fault_;
};

constexpr std::int64_t fault_step = 131;  ///< the fault's step

/// Steps from the fault until it was noticed; −1 if it never was in as many as given.
std::int64_t steps_until_noticed(FaultyExchange::Fault fault, std::int64_t steps = 300) {
    const Model model = small_model();
    State state = small_state(model);
    Health health(HealthLimits{}, state);
    FaultyExchange exchange(state, fault_step, std::move(fault));
    try {
        run_steps(model, state, exchange, health, fault_step + steps,
                  Clock::now() + std::chrono::seconds(60));
    } catch (const SimulationError& error) {
        EXPECT_GE(error.instability().step, fault_step);
        return error.instability().step - fault_step;
    }
    return -1;
}

/// Adds to the force on a site, which the exchange sees where the velocity will be.
void force_on(State& state, std::array<int, 2> site, Vec2 force) {
    std::visit(
        [&](auto& sites) {
            sites.velocity.x(site[0], site[1]) += force.x;
            sites.velocity.y(site[0], site[1]) += force.y;
        },
        state.sites);
}

void expect_noticed(FaultyExchange::Fault fault) {
    const std::int64_t steps = steps_until_noticed(std::move(fault));
    EXPECT_GE(steps, 0) << "never noticed";
    EXPECT_LE(steps, 100);
}

TEST(FaultInjection, a_run_without_a_fault_is_healthy) {
    EXPECT_EQ(steps_until_noticed([](State&) {}), -1);
}

TEST(FaultInjection, a_nan_in_one_population_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) {
        std::visit([](auto& sites) { sites.populations.set_slot(3, 16, 12, std::nan("")); },
                   s.sites);
    });
}

TEST(FaultInjection, a_nan_in_one_node_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.cells.x[7] = std::nan(""); });
}

TEST(FaultInjection, a_huge_force_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { force_on(s, {9, 12}, {50.0, 0.0}); });
}

TEST(FaultInjection, an_infinite_force_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) {
        force_on(s, {9, 7}, {0.0, std::numeric_limits<double>::infinity()});
    });
}

TEST(FaultInjection, a_node_jump_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.cells.y[20] += 3.0; });
}

TEST(FaultInjection, two_nodes_that_change_places_are_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) {
        std::swap(s.cells.x[10], s.cells.x[12]);
        std::swap(s.cells.y[10], s.cells.y[12]);
    });
}

TEST(FaultInjection, a_node_through_the_wall_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.cells.y[0] = -0.5; });
}

TEST(FaultInjection, a_fault_in_the_last_step_is_noticed_before_anybody_looks) {
    const auto fault = [](State& s) { force_on(s, {9, 12}, {50.0, 0.0}); };
    static_assert((fault_step + 1) % HealthLimits{}.interval != 0);
    EXPECT_EQ(steps_until_noticed(fault, 1), 1);
}

/// Spoils the force on one site at one step of a run whose state is not ours to touch.
class FaultyForce : public Periodic {
public:
    explicit FaultyForce(std::int64_t step, double force) : step_(step), force_(force) {}

    using Periodic::fill;
    using Periodic::fold;
    void fold(VectorField<>& field) override {
        Periodic::fold(field);
        on_one_thread([&] {
            if (step_-- == 0) field.x(9, 12) += force_;
        });
    }

private:
    std::int64_t step_;
    double force_;
};

class FailingRun : public TemporaryDirectory {
protected:
    /// Blows up soon after step `when` of 1000; what is thrown.
    SimulationError fail(double force = 50.0, std::int64_t when = 731) {
        FaultyForce exchange(when, force);
        const Model model = small_model();
        try {
            run_case(
                request, model, [&] { return small_state(model); }, exchange);
        } catch (const SimulationError& error) {
            return error;
        }
        throw std::logic_error("it did not fail");
    }
    fs::path failure(const std::string& name) const { return request.directory / "failure" / name; }

    RunRequest request = small_request(path("run"), 1000);
};

TEST_F(FailingRun, says_what_it_saw_where_and_what_it_kept) {
    const SimulationError error = fail();
    const std::string text = error.what();
    for (const char* word : {"unstable at step 7", "what:", "cause:", "write:", "kept:"})
        EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_NE(text.find(failure("").string().substr(0, failure("").string().size() - 1)),
              std::string::npos)
        << text;
    EXPECT_EQ(read_file(failure("why.txt")), text + "\n");
    EXPECT_EQ(read_json(request.directory / "status.json")["status"], "failed");

    const Instability& what = error.instability();
    const Json record = read_json(failure("failure.json"));
    EXPECT_EQ(record["step"], what.step);
    EXPECT_EQ(record["quantity"], what.quantity);
    EXPECT_EQ(record["x"], what.x);
    // The spoilt site is (9, 12), 0.5 um apart; the blow-up is near it.
    EXPECT_NEAR(what.x, 9.5 * 5e-7, 3e-6);
    EXPECT_NEAR(what.y, 12.5 * 5e-7, 3e-6);
}

TEST_F(FailingRun, keeps_a_sound_state_of_at_most_two_percent_before) {
    const SimulationError error = fail();
    const Model model = small_model();
    const ArchiveReader archive(failure("last_good"));
    const auto good = archive.value<std::int64_t>("step");
    EXPECT_LE(good, 731);
    EXPECT_GE(good, 731 - 40);  // 20 by default, more where copies are dear
    EXPECT_EQ(read_json(failure("failure.json"))["last_good_step"], good);
    EXPECT_LT(ArchiveReader(request.directory / "checkpoint/current").value<std::int64_t>("step"),
              good);
    Periodic exchange;
    const State state = load_state(archive, model, exchange);
    EXPECT_FALSE(Health(request.limits, state).examine(model, state).has_value());
}

TEST_F(FailingRun, leaves_a_frame_of_the_failing_state) {
    const SimulationError error = fail();
    const FramesReader frames(failure("frames.h5"));
    ASSERT_EQ(frames.count(), 2);
    EXPECT_EQ(frames.frame(0).step, read_json(failure("failure.json"))["last_good_step"]);
    const Frame frame = frames.frame(1);
    EXPECT_EQ(frame.step, error.instability().step);
    double fastest = 0.0;  // m/s; the walls move at 0.01
    for (const float u : frame.velocity) fastest = std::max<double>(fastest, std::abs(u));
    EXPECT_GT(fastest, 0.05) << "the velocity is that of the failing state";
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
    return n;
}

TEST_F(FailingRun, is_shown_on_the_page_with_the_place_marked) {
    request.name = "<b>&";
    const SimulationError error = fail();
    const std::string section = failure_section(read_results(request.directory), "<b>&", "failure");
    EXPECT_NE(section.find("Why &lt;b&gt;&amp; failed</a></h2>"), std::string::npos) << section;
    EXPECT_NE(section.find("unstable at step"), std::string::npos);
    EXPECT_EQ(count(section, "<svg"), 2) << "all of the box, and what is near";
    EXPECT_EQ(count(section, "class=\"failing\""), 2);
    // Mid of the close-up, in um, y downwards: the box is 12 um high.
    const Instability& what = error.instability();
    EXPECT_NE(
        section.find(fmt::format("cx=\"{:.3f}\" cy=\"{:.3f}\"", what.x * 1e6, 12.0 - what.y * 1e6)),
        std::string::npos)
        << section;
    EXPECT_EQ(count(section, "nan"), 0);
}

TEST_F(FailingRun, with_numbers_that_are_not_finite_is_told_all_the_same) {
    const SimulationError error = fail(std::nan(""));
    EXPECT_TRUE(fs::exists(failure("failure.json")));
    EXPECT_EQ(FramesReader(failure("frames.h5")).count(), 2);
    EXPECT_TRUE(read_json(failure("failure.json"))["value"].is_null());
    const std::string section =
        failure_section(read_results(request.directory), "small", "failure");
    EXPECT_EQ(count(section, "<svg"), 2);
    EXPECT_EQ(section.find("nan", section.find("<svg")), std::string::npos) << section;
}

/// What was kept is a checkpoint: with the cause gone, the run goes on from it to the same bits.
TEST_F(FailingRun, can_go_on_from_what_it_kept) {
    fail();
    move_into_place(failure("last_good"), request.directory / "checkpoint/current",
                    Durability::process);
    fs::remove_all(request.directory / "failure");
    run_small(request);
    const RunRequest straight = small_request(path("straight"), 1000);
    run_small(straight);
    for (const char* name : {"series.csv", "cells.csv", "profiles.csv"})
        EXPECT_EQ(read_file(request.directory / name), read_file(straight.directory / name));
    EXPECT_EQ(read_json(request.directory / "PROVENANCE.json")["state_hash"],
              read_json(straight.directory / "PROVENANCE.json")["state_hash"]);
}

TEST_F(FailingRun, whose_first_state_is_faulty_writes_nothing_of_it_but_the_failure) {
    Model model = small_model();
    Periodic exchange;
    const auto folded = [&] {
        State state = small_state(model);
        std::swap(state.cells.x[10], state.cells.x[12]);
        std::swap(state.cells.y[10], state.cells.y[12]);
        return state;
    };
    EXPECT_THROW(run_case(request, model, folded, exchange), SimulationError);
    EXPECT_FALSE(fs::exists(request.directory / "checkpoint/current"));
    EXPECT_FALSE(fs::exists(failure("last_good")));
    EXPECT_TRUE(fs::exists(failure("failure.json")));
    const std::string series = read_file(request.directory / "series.csv");
    EXPECT_EQ(std::count(series.begin(), series.end(), '\n'), 1) << "the header alone";
}

}  // namespace
}  // namespace tt
