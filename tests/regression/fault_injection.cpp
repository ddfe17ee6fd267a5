#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "io/archive.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

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
    void fold(VectorField& field) override {
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

constexpr std::int64_t when = 131;  ///< the fault's step

/// Steps from the fault until it was noticed; −1 if it never was in as many as given.
std::int64_t steps_until_noticed(FaultyExchange::Fault fault, std::int64_t steps = 300) {
    const Model model = small_model();
    State state = small_state(model);
    Health health(HealthLimits{}, state);
    FaultyExchange exchange(state, when, std::move(fault));
    try {
        run_steps(model, state, exchange, health, when + steps,
                  Clock::now() + std::chrono::seconds(60));
    } catch (const SimulationError& error) {
        EXPECT_GE(error.instability().step, when);
        return error.instability().step - when;
    }
    return -1;
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
    expect_noticed([](State& s) { s.populations.set_slot(3, 16, 12, std::nan("")); });
}

TEST(FaultInjection, a_nan_in_one_node_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.cells.x[7] = std::nan(""); });
}

TEST(FaultInjection, a_huge_force_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.force.x(9, 12) += 50.0; });
}

TEST(FaultInjection, an_infinite_force_is_noticed_within_a_hundred_steps) {
    expect_noticed([](State& s) { s.force.y(9, 7) = std::numeric_limits<double>::infinity(); });
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
    const auto fault = [](State& s) { s.force.x(9, 12) += 50.0; };
    static_assert((when + 1) % HealthLimits{}.interval != 0);
    EXPECT_EQ(steps_until_noticed(fault, 1), 1);
}

using FailingRun = TemporaryDirectory;

TEST_F(FailingRun, keeps_the_last_good_state_and_says_why) {
    Model model = small_model();
    model.membrane.in_plane = NeoHookean{40.0};  // far beyond what the time step bears
    const RunRequest request = small_request(path("run"), 1000);
    EXPECT_THROW(run_small(request, model), SimulationError);

    const auto step_of = [&](const std::string& name) {
        return ArchiveReader(path("run") / name).value<std::int64_t>("step");
    };
    EXPECT_LT(step_of("failure/last_good"), step_of("failure/failing"));
    EXPECT_EQ(step_of("checkpoint/current"), step_of("failure/last_good"));
    const std::string why = read_file(path("run") / "failure/why.txt");
    for (const char* word : {"unstable at step", "limit", "cause:", "cure:"}) {
        EXPECT_NE(why.find(word), std::string::npos) << why;
    }
    EXPECT_NE(read_file(path("run") / "status.json").find("\"failed\""), std::string::npos);

    Periodic exchange;
    const State good =
        load_state(ArchiveReader(path("run") / "checkpoint/current"), model, exchange);
    EXPECT_FALSE(Health(request.limits, good).examine(model, good).has_value());
}

}  // namespace
}  // namespace tt
