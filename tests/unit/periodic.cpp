#include <gtest/gtest.h>

#include <array>

#include "base/random.hpp"
#include "exchange/periodic.hpp"

namespace {

using namespace tt;

constexpr int reach = Lattice::halo;
const std::array<Lattice, 5> lattices{
    {{7, 5, true}, {7, 5, false}, {1, 1, false}, {2, 1, true}, {1, 3, false}}};

/// Calls f(i, j) for every site and halo site.
template <class F>
void for_each_place(const Lattice& lattice, F&& f) {
    for (int j = -reach; j < lattice.ny + reach; ++j) {
        for (int i = -reach; i < lattice.nx + reach; ++i) f(i, j);
    }
}

bool beyond_wall(const Lattice& lattice, int j) {
    return lattice.walls && (j < 0 || j >= lattice.ny);
}
bool is_site(const Lattice& lattice, int i, int j) {
    return i >= 0 && i < lattice.nx && j >= 0 && j < lattice.ny;
}

VectorField<> random_field(const Lattice& lattice, Random& random) {
    VectorField field(lattice);
    for_each_place(lattice, [&](int i, int j) {
        field.x(i, j) = random.uniform(-1.0, 1.0);
        field.y(i, j) = random.uniform(-1.0, 1.0);
    });
    return field;
}

TEST(Periodic, fill_repeats_the_sites_in_the_halo_and_spares_what_lies_beyond_a_wall) {
    for (const Lattice& lattice : lattices) {
        VectorField field(lattice);
        for (int j = 0; j < lattice.ny; ++j) {
            for (int i = 0; i < lattice.nx; ++i) field.x(i, j) = 1.0 + 10.0 * j + i;
        }
        Periodic exchange;
        with_team(2, [&] { exchange.fill(field); });
        for_each_place(lattice, [&](int i, int j) {
            const int x = (i + 2 * lattice.nx) % lattice.nx;
            const int y = (j + 2 * lattice.ny) % lattice.ny;
            EXPECT_EQ(field.x(i, j), beyond_wall(lattice, j) ? 0.0 : 1.0 + 10.0 * y + x);
        });
    }
}

TEST(Periodic, fold_is_the_transpose_of_fill_and_clears_the_halo) {
    Random random(1);
    for (const Lattice& lattice : lattices) {
        VectorField<> filled = random_field(lattice, random);
        const VectorField<> spread = random_field(lattice, random);
        VectorField<> folded = spread;
        Periodic exchange;
        with_team(2, [&] {
            exchange.fill(filled);
            exchange.fold(folded);
        });
        double difference = 0.0;
        for_each_place(lattice, [&](int i, int j) {
            if (!beyond_wall(lattice, j)) difference += dot(filled(i, j), spread(i, j));
            if (is_site(lattice, i, j)) {
                difference -= dot(filled(i, j), folded(i, j));
            } else {
                EXPECT_EQ(folded(i, j), Vec2{});
            }
        });
        EXPECT_NEAR(difference, 0.0, 1e-13);
    }
}

TEST(Periodic, settle_turns_the_phase_and_leaves_every_population_readable) {
    for (const Lattice& lattice : lattices) {
        Populations populations(lattice);
        Random random(2);
        for (int k = 0; k < d2q9::count; ++k) {
            for (int j = 0; j < lattice.ny; ++j) {
                for (int i = 0; i < lattice.nx; ++i)
                    populations.set_slot(k, i, j, random.uniform());
            }
        }
        const Populations<> start = populations;
        Periodic exchange;
        settle(exchange, populations);
        EXPECT_EQ(populations.phase, Phase::odd);
        for (int k = 0; k < d2q9::count; ++k) {
            const int x = (lattice.nx - d2q9::cx[k]) % lattice.nx;
            const int y = (lattice.ny - d2q9::cy[k]) % lattice.ny;
            const bool bounced = beyond_wall(lattice, -d2q9::cy[k]);
            EXPECT_EQ(populations.arriving(k, 0, 0),
                      bounced ? start.slot(k, 0, 0) : start.slot(d2q9::opposite[k], x, y));
        }
        settle(exchange, populations);
        EXPECT_EQ(populations.phase, Phase::even);
        for (int k = 0; k < d2q9::count; ++k) {
            for (int j = 0; j < lattice.ny; ++j) {
                for (int i = 0; i < lattice.nx; ++i)
                    EXPECT_EQ(populations.slot(k, i, j), start.slot(k, i, j));
            }
        }
    }
}

}  // namespace
