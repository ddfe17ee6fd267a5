#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/derive.hpp"
#include "simulation/state_archive.hpp"
#include "small_run.hpp"

namespace tt {
namespace {

/// The state after some steps of two cells that feel each other, the flow kept everywhere in some
/// of them.
std::uint64_t hash_after_steps(bool walls, bool post, int threads) {
    Model model = small_model();
    model.lattice.walls = walls;
    if (post) model = with_post(model);
    model.contact.law = Morse{1e-3, 0.77, 2.45, true};
    model.contact.range = 9.0;
    model.contact.interval = 3;
    model.contact.repulsion_range = 8.5;
    model.contact.repulsion_strength = 1e-5;
    State state = small_state(model);
    derive(model, state);
    Periodic exchange;
    with_team(threads, [&] {
        for (int k = 0; k < 150; ++k) advance(model, state, exchange);
    });
    EXPECT_GT(state.contact.repulsion_count, 0);
    return state_hash(state);
}

TEST(Threads, steps_give_the_same_bits_on_1_to_8) {
    for (const bool walls : {true, false})
        for (const bool post : {false, true}) {
            const std::uint64_t one = hash_after_steps(walls, post, 1);
            for (const int threads : {2, 3, 5, 8})
                EXPECT_EQ(hash_after_steps(walls, post, threads), one) << threads << " threads";
        }
}

}  // namespace
}  // namespace tt
