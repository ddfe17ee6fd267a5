#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

using Restart = TemporaryDirectory;

void advance_by(const Model& model, State& state, int steps) {
    Periodic exchange;
    with_team(model.threads, [&] {
        for (int k = 0; k < steps; ++k) advance(model, state, exchange);
    });
}

State saved_and_loaded(const Model& model, const State& state, const std::filesystem::path& path) {
    ArchiveWriter archive(path);
    save_state(archive, state);
    archive.commit();
    Periodic exchange;
    return load_state(ArchiveReader(path), model, exchange);
}

TEST_F(Restart, two_hundred_steps_are_a_hundred_saved_loaded_and_a_hundred_more) {
    for (const auto& [precision, post] : {std::pair{Precision::fp64, false},
                                          {Precision::fp32, false},
                                          {Precision::fp64, true},
                                          {Precision::fp32, true}}) {
        Model model = post ? with_post(small_model()) : small_model();
        model.precision = precision;
        model.contact.law = Morse{1e-3, 0.77, 2.45, true};
        model.contact.range = 9.0;
        model.contact.interval = 4;  // of which a run may stop in the middle
        State straight = small_state(model);
        advance_by(model, straight, 200);
        for (const int first : {1, 98, 99, 100}) {  // the odd phase of the populations too
            State state = small_state(model);
            advance_by(model, state, first);
            State loaded = saved_and_loaded(model, state, path("state"));
            EXPECT_EQ(loaded.sites.index(), state.sites.index());
            EXPECT_EQ(state_hash(loaded), state_hash(state));
            advance_by(model, loaded, 200 - first);
            EXPECT_EQ(state_hash(loaded), state_hash(straight)) << "saved at step " << first;
        }
    }
}

TEST_F(Restart, the_hash_sees_one_bit_of_one_population_and_of_one_node) {
    const Model model = small_model();
    State state = small_state(model);
    advance_by(model, state, 2);
    const std::uint64_t before = state_hash(state);
    Populations<>& populations = in_double(state).populations;
    const double population = populations.slot(5, 32, 23);
    populations.set_slot(5, 32, 23, std::nextafter(population, 1.0));
    EXPECT_NE(state_hash(state), before);
    populations.set_slot(5, 32, 23, population);
    EXPECT_EQ(state_hash(state), before);
    state.cells.x[67] = std::nextafter(state.cells.x[67], 0.0);
    EXPECT_NE(state_hash(state), before);
}

TEST_F(Restart, a_state_of_another_lattice_is_refused) {
    Model model = small_model();
    ArchiveWriter archive(path("state"));
    save_state(archive, small_state(model));
    archive.commit();
    model.lattice.nx += 1;
    Periodic exchange;
    EXPECT_THROW(load_state(ArchiveReader(path("state")), model, exchange), DamagedArchive);
}

/// Where the hash of a state and what is loaded must show it: one number after the other.
TEST_F(Restart, every_number_of_a_state_is_hashed_and_comes_back) {
    const Model model = small_model();
    State state = small_state(model);
    advance_by(model, state, 3);
    state.drive.body_force = 1e-5;
    state.drive.integral = 2e-3;
    state.contact.repulsion_count = 17;
    const auto change = [](double& value) { value = std::nextafter(value, 1e9); };
    Suspension& cells = state.cells;
    const std::vector<std::function<void()>> changes{
        [&] { ++state.step; },
        [&] { change(state.drive.body_force); },
        [&] { change(state.drive.integral); },
        [&] { ++state.contact.repulsion_count; },
        [&] { change(cells.x[5]); },
        [&] { change(cells.y[5]); },
        [&] { change(cells.pair_fx[5]); },
        [&] { change(cells.pair_fy[5]); },
        [&] { change(cells.ux[5]); },
        [&] { change(cells.uy[5]); },
        [&] { change(cells.ux_sampled[5]); },
        [&] { change(cells.uy_sampled[5]); },
        [&] { change(cells.rest_length[5]); },
        [&] { change(cells.rest_curvature[5]); },
        [&] { change(cells.reference_area[1]); },
        [&] { change(cells.reference_perimeter[1]); },
        [&] { change(state.interior.x[40]); },
        [&] { change(state.interior.y[40]); },
    };
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const std::uint64_t before = state_hash(state);
        changes[k]();
        EXPECT_NE(state_hash(state), before) << "change " << k;
        const State loaded = saved_and_loaded(model, state, path("state"));
        EXPECT_EQ(state_hash(loaded), state_hash(state)) << "change " << k;
    }
}

/// The checksum of such a file is right: what it holds is not.
TEST_F(Restart, a_forged_state_is_refused_before_it_is_used) {
    const Model model = small_model();
    const double nan = std::nan("");
    const std::vector<std::function<void(State&)>> forgeries{
        [&](State& s) { s.cells.x[7] = nan; },
        [&](State& s) { s.cells.uy[7] = nan; },
        [&](State& s) { s.interior.x[7] = nan; },
        [&](State& s) { s.drive.integral = nan; },
        [&](State& s) { s.cells.alpha[0] = nan; },
        [&](State& s) { s.cells.x[7] = 1e12; },
        [&](State& s) { s.cells.x[7] += 1000.0; },
        [&](State& s) { s.interior.y[7] = -1e300; },
        [&](State& s) { s.cells.y[7] = -3.0; },
        [&](State& s) { s.step = -1; },
        [&](State& s) { s.cells.first[1] = 1; },
        [&](State& s) { s.cells.first[1] = 1'000'000'000; },
        [&](State& s) { s.cells.first = {0}; },
        [&](State& s) { s.cells.first = {}; },
        [&](State& s) { s.cells.area.pop_back(); },
        [&](State& s) { s.cells.fx.pop_back(); },
    };
    for (std::size_t k = 0; k < forgeries.size(); ++k) {
        State state = small_state(model);
        advance_by(model, state, 1);
        forgeries[k](state);
        EXPECT_THROW(saved_and_loaded(model, state, path("state")), DamagedArchive) << k;
    }
}

}  // namespace
}  // namespace tt
