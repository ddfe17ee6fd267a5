#include <gtest/gtest.h>

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
    for (const Precision precision : {Precision::fp64, Precision::fp32}) {
        Model model = small_model();
        model.precision = precision;
        State straight = small_state(model);
        advance_by(model, straight, 200);
        for (const int first : {1, 99, 100}) {  // the odd phase of the populations too
            State state = small_state(model);
            advance_by(model, state, first);
            State loaded = saved_and_loaded(model, state, path("state"));
            EXPECT_EQ(loaded.populations.precision(), precision);
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
    const double population = state.populations.slot(5, 32, 23);
    state.populations.set_slot(5, 32, 23, std::nextafter(population, 1.0));
    EXPECT_NE(state_hash(state), before);
    state.populations.set_slot(5, 32, 23, population);
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

}  // namespace
}  // namespace tt
