#include "membrane/implicit_tension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "base/random.hpp"
#include "membrane/forces.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// Of all cells.
void set_membrane_forces(const Membrane& membrane, Suspension& cells) {
    for_own_cells(cells, [&](int cell) { tt::set_membrane_forces(membrane, cells, cell); });
}

constexpr double mobility = 5.0;

/// A stretched ellipse with its stiffness set and random velocities.
Suspension moving_cell(const Membrane& membrane, int nodes = 45) {
    Suspension cells;
    add_cell(cells, placed(ellipse(9.0, 5.0, nodes), 0.4, {20.0, 15.0}));
    Random random(3);
    for (int k = 0; k < nodes; ++k) {
        cells.x[k] *= 1.1;
        cells.y[k] += random.uniform(-0.05, 0.05);
        cells.ux[k] = random.uniform(-0.01, 0.01);
        cells.uy[k] = random.uniform(-0.01, 0.01);
    }
    set_membrane_forces(membrane, cells);
    return cells;
}

Membrane hardened_membrane() {
    Membrane membrane;
    membrane.in_plane = NeoHookean{0.02};
    membrane.hardening = hardened_throughout(0.55, 16.0);
    return membrane;
}

int next_of(const Suspension& cells, int k) { return k + 1 < cells.node_count() ? k + 1 : 0; }

Vec2 tangent(const Suspension& cells, int k) {
    const Vec2 edge = cells.position(next_of(cells, k)) - cells.position(k);
    return edge / norm(edge);
}

/// The tension of segment k that the move makes, as a velocity: K_k e_k.
double answer(const Suspension& cells, double m, int k) {
    const Vec2 apart = cells.velocity(next_of(cells, k)) - cells.velocity(k);
    return m * cells.stiffness[k] * dot(tangent(cells, k), apart);
}

TEST(ImplicitTension, velocities_are_those_with_the_tension_that_they_make) {
    Suspension cells = moving_cell(hardened_membrane());
    const Suspension before = cells;
    // So soft that eight sweeps are exact: each takes off 2 K/(1 + 2 K) of what is left.
    const double soft = 0.2 / *std::max_element(cells.stiffness.begin(), cells.stiffness.end());
    answer_with_tension(soft, cells, 0);
    double answered = 0.0;
    for (int k = 0; k < cells.node_count(); ++k) {
        const int last = k > 0 ? k - 1 : cells.node_count() - 1;
        answered = std::max(answered, norm(cells.velocity(k) - before.velocity(k)));
        const Vec2 expected = before.velocity(k) + answer(cells, soft, k) * tangent(cells, k) -
                              answer(cells, soft, last) * tangent(cells, last);
        EXPECT_LT(norm(cells.velocity(k) - expected), 1e-6) << k;
    }
    EXPECT_GT(answered, 1e-3);
}

TEST(ImplicitTension, sum_and_moment_of_the_velocities_stay_and_forces_too) {
    Suspension cells = moving_cell(hardened_membrane());
    const Suspension before = cells;
    answer_with_tension(mobility, cells, 0);
    Vec2 sum;
    double moment = 0.0, moved = 0.0;
    for (int k = 0; k < cells.node_count(); ++k) {
        const Vec2 change = cells.velocity(k) - before.velocity(k);
        sum += change;
        moment += cross(cells.position(k), change);
        moved += norm(change);
    }
    EXPECT_GT(moved, 0.1);
    EXPECT_LT(norm(sum), 1e-15);
    EXPECT_LT(std::abs(moment), 1e-13);
    EXPECT_EQ(cells.fx, before.fx);
    EXPECT_EQ(cells.fy, before.fy);
}

TEST(ImplicitTension, a_cell_that_moves_as_a_rigid_body_feels_nothing) {
    Suspension cells = moving_cell(hardened_membrane());
    for (int k = 0; k < cells.node_count(); ++k) {
        cells.ux[k] = 0.02 - 1e-3 * cells.y[k];
        cells.uy[k] = 0.01 + 1e-3 * cells.x[k];
    }
    const Suspension before = cells;
    answer_with_tension(mobility, cells, 0);
    for (int k = 0; k < cells.node_count(); ++k)
        EXPECT_LT(norm(cells.velocity(k) - before.velocity(k)), 1e-16);
}

/// T(λ) α(λ) of a law, for its slope.
TEST(ImplicitTension, stiffness_is_how_tension_grows_with_length_and_never_negative) {
    using Compression = Hardening::Compression;
    using Form = Hardening::Form;
    for (const InPlane& law : {InPlane{NeoHookean{0.02}}, InPlane{Hookean{0.02}},
                               InPlane{Skalak{0.02, 0.5}}, InPlane{SurfaceTension{0.02}}}) {
        for (const Form form : {Form::exponential, Form::power_exponential}) {
            for (const Compression compression :
                 {Compression::symmetric, Compression::one, Compression::as_printed}) {
                Membrane membrane;
                membrane.in_plane = law;
                membrane.hardening = {form, compression, 0.55, 6.0, true};
                const Suspension cells = moving_cell(membrane);
                const auto tension = [&](double stretch) {
                    return membrane.hardening(stretch) *
                           std::visit([&](const auto& l) { return l.tension(stretch); }, law);
                };
                for (int k = 0; k < cells.node_count(); ++k) {
                    const double stretch =
                        norm(cells.position(next_of(cells, k)) - cells.position(k)) /
                        cells.rest_length[k];
                    const double slope = (tension(stretch + 1e-6) - tension(stretch - 1e-6)) / 2e-6;
                    EXPECT_NEAR(cells.stiffness[k], std::max(0.0, slope) / cells.rest_length[k],
                                1e-8)
                        << law.index() << " " << stretch;
                }
            }
        }
    }
}

}  // namespace
}  // namespace tt
