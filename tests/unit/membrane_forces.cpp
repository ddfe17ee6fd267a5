#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/exp.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "membrane/forces.hpp"
#include "membrane/shapes.hpp"

using namespace tt;

namespace {

/// Of all cells.
void set_membrane_forces(const Membrane& membrane, Suspension& cells) {
    for_own_cells(cells, [&](int cell) { tt::set_membrane_forces(membrane, cells, cell); });
}

/// A cell bent out of shape by smooth random waves.
void disturb(Suspension& cells, double amplitude, std::uint64_t seed) {
    Random random(seed);
    for (int c = 0; c < cells.cell_count(); ++c) {
        const int first = cells.first[c], count = cells.node_count(c);
        for (int wave = 1; wave <= 4; ++wave) {
            const double phase_x = random.uniform(0.0, 6.28), phase_y = random.uniform(0.0, 6.28);
            for (int k = 0; k < count; ++k) {
                const double angle = 2.0 * std::numbers::pi * wave * k / count;
                cells.x[first + k] += amplitude / wave * std::sin(angle + phase_x);
                cells.y[first + k] += amplitude / wave * std::sin(angle + phase_y);
            }
        }
    }
}

Suspension three_cells() {
    Suspension cells;
    add_cell(cells, placed(circle(20.0, 126), 0.0, {30.0, 30.0}));
    add_cell(cells, placed(ellipse(25.0, 12.0, 117), 0.7, {90.0, 40.0}));
    add_cell(cells, placed(biconcave(19.5, 97), -0.3, {150.0, 35.0}));
    return cells;
}

Membrane full_membrane(InPlane law, Bending bending) {
    Membrane membrane;
    membrane.in_plane = law;
    membrane.bending = bending;
    membrane.area_stiffness = 0.02;
    membrane.hardening = hardened_throughout(0.55, 16.0);
    return membrane;
}

/// Energy of tension and area; of bending where the law has one.
double energy(const Membrane& membrane, const Suspension& cells) {
    double sum = 0.0;
    for (int c = 0; c < cells.cell_count(); ++c) {
        std::vector<Vec2> points;
        const int first = cells.first[c], count = cells.node_count(c);
        for (int k = 0; k < count; ++k) points.push_back(cells.position(first + k));
        for (int k = 0; k < count; ++k) {
            const Vec2 here = points[k], next = points[(k + 1) % count],
                       before = points[(k + count - 1) % count];
            const double stretch = norm(next - here) / cells.rest_length[first + k];
            sum +=
                cells.rest_length[first + k] *
                std::visit([&](const auto& law) { return law.energy(stretch); }, membrane.in_plane);
            if (const auto* law = std::get_if<ReferenceCurvature>(&membrane.bending)) {
                // ∫ m dθ with m = E_b (2 tan(θ/2)/s − κ₀): E_b (−4 ln cos(θ/2)/s − κ₀ θ).
                const double arc = 0.5 * (cells.rest_length[first + k] +
                                          cells.rest_length[first + (k + count - 1) % count]);
                const double theta =
                    std::atan2(cross(here - before, next - here), dot(here - before, next - here));
                sum += law->modulus * (-4.0 * std::log(std::cos(0.5 * theta)) / arc -
                                       cells.rest_curvature[first + k] * theta);
            }
        }
        const double defect = 1.0 - area_of(points) / cells.reference_area[c];
        sum += 0.5 * membrane.area_stiffness * cells.reference_area[c] * defect * defect;
    }
    return sum;
}

/// Calls f(node, before, after) for every node with the vectors of its two segments.
template <class F>
void for_each_corner(const Suspension& s, F&& f) {
    for (int c = 0; c < s.cell_count(); ++c) {
        const int first = s.first[c], count = s.node_count(c);
        for (int k = 0; k < count; ++k) {
            const Vec2 here = s.position(first + k);
            f(first + k, here - s.position(first + (k + count - 1) % count),
              s.position(first + (k + 1) % count) - here);
        }
    }
}

double turning(Vec2 before, Vec2 after) {
    return std::atan2(cross(before, after), dot(before, after));
}

/// Eq. 13 without hardening at every node, its curvature by the lengths as they are.
std::vector<double> moments(double modulus, const Suspension& s) {
    std::vector<double> moment(s.node_count());
    for_each_corner(s, [&](int node, Vec2 before, Vec2 after) {
        const double curvature =
            2.0 * std::tan(0.5 * turning(before, after)) / (0.5 * (norm(before) + norm(after)));
        moment[node] = modulus * (curvature - s.rest_curvature[node]);
    });
    return moment;
}

void expect_forces_are_minus_the_gradient(const Membrane& membrane) {
    Suspension cells = three_cells();
    disturb(cells, 1.0, 7);
    set_membrane_forces(membrane, cells);
    double largest = 0.0;
    for (int n = 0; n < cells.node_count(); ++n)
        largest = std::fmax(largest, std::hypot(cells.fx[n], cells.fy[n]));
    for (int n = 0; n < cells.node_count(); n += 5) {
        for (std::vector<double>* axis : {&cells.x, &cells.y}) {
            const double before = (*axis)[n], d = 1e-5;
            (*axis)[n] = before + d;
            const double up = energy(membrane, cells);
            (*axis)[n] = before - d;
            const double down = energy(membrane, cells);
            (*axis)[n] = before;
            const double force = axis == &cells.x ? cells.fx[n] : cells.fy[n];
            EXPECT_NEAR(force, -(up - down) / (2.0 * d), 2e-6 * largest) << "node " << n;
        }
    }
}

class EveryLaw : public testing::TestWithParam<InPlane> {};

TEST_P(EveryLaw, forces_are_minus_the_gradient_of_the_energy) {
    Membrane membrane;
    membrane.in_plane = GetParam();
    membrane.bending = ReferenceCurvature{0.3};
    membrane.area_stiffness = 0.02;
    expect_forces_are_minus_the_gradient(membrane);
}

TEST_P(EveryLaw, tension_is_the_derivative_of_the_energy_and_vanishes_at_rest_but_for_a_drop) {
    std::visit(
        [](const auto& law) {
            const double at_rest = law.name == SurfaceTension::name ? law.shear_modulus : 0.0;
            EXPECT_NEAR(law.tension(1.0), at_rest, 1e-18);
            for (double stretch : {0.6, 0.9, 1.1, 1.7}) {
                const double d = 1e-5;
                const double slope =
                    (law.energy(stretch + d) - law.energy(stretch - d)) / (2.0 * d);
                EXPECT_NEAR(law.tension(stretch), slope, 1e-8 * law.shear_modulus);
            }
        },
        GetParam());
}

TEST_P(EveryLaw, membrane_forces_and_torques_sum_to_zero) {
    for (const Bending bending :
         {Bending{CurrentCurvature{0.3}}, Bending{ReferenceCurvature{0.3}}}) {
        Suspension cells = three_cells();
        disturb(cells, 2.0, 3);
        set_membrane_forces(full_membrane(GetParam(), bending), cells);
        for (int c = 0; c < cells.cell_count(); ++c) {
            Vec2 force;
            double torque = 0.0, scale = 0.0;
            for (int n = cells.first[c]; n < cells.first[c + 1]; ++n) {
                force += cells.force(n);
                torque += cross(cells.position(n), cells.force(n));
                scale += norm(cells.force(n));
            }
            EXPECT_GT(scale, 0.0);
            EXPECT_LT(norm(force), 1e-12 * scale);
            EXPECT_LT(std::fabs(torque), 1e-12 * scale * norm(cells.position(cells.first[c])));
        }
    }
}

std::vector<InPlane> all_laws() {
    std::vector<InPlane> laws;
    for_each_alternative<InPlane>([&]<class Law>() {
        Law law;
        law.shear_modulus = 0.01;
        laws.emplace_back(law);
    });
    return laws;
}

INSTANTIATE_TEST_SUITE_P(InPlane, EveryLaw, testing::ValuesIn(all_laws()));

TEST(MembraneForces, vanish_on_the_stress_free_shape) {
    Suspension cells = three_cells();
    set_membrane_forces(full_membrane(NeoHookean{0.01}, CurrentCurvature{0.3}), cells);
    for (int n = 0; n < cells.node_count(); ++n) EXPECT_LT(norm(cells.force(n)), 1e-14);
}

TEST(MembraneForces, bending_does_the_virtual_work_of_its_moment) {
    // With the moments frozen, F·δX = −Σ m δθ for every displacement: Eq. 13 has no energy, but
    // this much it has.
    Suspension cells = three_cells();
    disturb(cells, 1.5, 11);
    Membrane membrane;
    membrane.in_plane = NeoHookean{0.0};
    membrane.bending = CurrentCurvature{0.3};
    set_membrane_forces(membrane, cells);
    const std::vector<double> moment = moments(0.3, cells);
    const auto work = [&](const Suspension& s) {
        double sum = 0.0;
        for_each_corner(s, [&](int node, Vec2 before, Vec2 after) {
            sum += moment[node] * turning(before, after);
        });
        return sum;
    };
    for (int n = 0; n < cells.node_count(); n += 7) {
        const double d = 1e-6, before = cells.y[n];
        cells.y[n] = before + d;
        const double up = work(cells);
        cells.y[n] = before - d;
        const double down = work(cells);
        cells.y[n] = before;
        EXPECT_NEAR(cells.fy[n], -(up - down) / (2.0 * d), 1e-7);
    }
}

TEST(MembraneForces, inflated_circle_is_held_by_the_line_tension_and_bending_of_theory) {
    // Circle of radius a stretched to λa: T/(λa) inward from tension; uniform moment has no shear;
    // pressure outward.
    const double a = 20.0, stretch = 1.2;
    Suspension cells;
    add_cell(cells, circle(a, 400));
    for (int n = 0; n < cells.node_count(); ++n) {
        cells.x[n] *= stretch;
        cells.y[n] *= stretch;
    }
    Membrane membrane;
    membrane.in_plane = NeoHookean{0.01};
    membrane.bending = CurrentCurvature{0.3};
    set_membrane_forces(membrane, cells);
    const double tension = 0.01 * (std::pow(stretch, 3) - 1.0) / std::pow(stretch, 1.5);
    const double arc = norm(cells.position(1) - cells.position(0));
    EXPECT_NEAR(cells.fx[0] / arc, -tension / (stretch * a), 1e-4 * tension / a);
    // Uniform, the moment shows in no force here; that forces do its work is tested above.
    EXPECT_NEAR(moments(0.3, cells)[5], 0.3 * (1.0 / (stretch * a) - 1.0 / a), 1e-4 * 0.3 / a);
}

TEST(MembraneForces, are_the_same_bits_for_any_number_of_threads) {
    Suspension one = three_cells();
    disturb(one, 2.0, 5);
    Suspension many = one;
    const Membrane membrane = full_membrane(NeoHookean{0.01}, CurrentCurvature{0.3});
    set_membrane_forces(membrane, one);
    for (int threads : {2, 3, 5, 8}) {
        with_team(threads, [&] { set_membrane_forces(membrane, many); });
        EXPECT_EQ(one.fx, many.fx) << threads;
        EXPECT_EQ(one.fy, many.fy) << threads;
    }
}

TEST(Hardening, is_one_at_rest_and_as_stated_in_compression) {
    using Form = Hardening::Form;
    using Compression = Hardening::Compression;
    for (Form form : {Form::exponential, Form::power_exponential}) {
        Hardening hardening{form, Compression::symmetric, 0.4, 9.0, true, true, true, true};
        EXPECT_NEAR(hardening(1.0), 1.0, 1e-15);
        EXPECT_GT(hardening(1.1), 1.0);
        EXPECT_DOUBLE_EQ(hardening(0.9), hardening(1.1));
        hardening.compression = Compression::one;
        EXPECT_EQ(hardening(0.9), 1.0);
        hardening.compression = Compression::as_printed;
        EXPECT_LT(hardening(0.9), 1.0);
        const double slope = form == Form::exponential ? 0.4 * 9.0 : std::numbers::e * 0.4 * 9.0;
        EXPECT_NEAR((hardening(1.0 + 1e-6) - 1.0) / 1e-6, slope, 1e-3);
    }
}

TEST(Hardening, of_the_tension_is_the_hardening_law) {
    for (auto compression : {Hardening::Compression::symmetric, Hardening::Compression::one,
                             Hardening::Compression::as_printed}) {
        Suspension cells = three_cells();
        disturb(cells, 2.0, 9);
        Membrane membrane;
        membrane.in_plane = NeoHookean{0.01};
        membrane.hardening = hardened_throughout(0.4, 9.0);
        membrane.hardening.compression = compression;
        set_membrane_forces(membrane, cells);
        bool compressed = false;
        for (int c = 0; c < cells.cell_count(); ++c) {
            const int first = cells.first[c], count = cells.node_count(c);
            const auto pull = [&](int k) {
                const int n = first + k % count;
                const Vec2 edge = cells.position(first + (k + 1) % count) - cells.position(n);
                const double stretch = norm(edge) / cells.rest_length[n];
                compressed = compressed || stretch < 0.97;
                return edge * (NeoHookean{0.01}.tension(stretch) * membrane.hardening(stretch) /
                               norm(edge));
            };
            for (int k = 0; k < count; ++k) {
                const Vec2 after = pull(k), before = pull(k + count - 1);
                const double rounding = 1e-13 * (norm(after) + norm(before));
                EXPECT_LE(norm(cells.force(first + k) - (after - before)), rounding);
            }
        }
        EXPECT_TRUE(compressed);
    }
}

TEST(VectorExp, agrees_with_the_library_to_a_few_ulp) {
    for (double x = -40.0; x < 40.0; x += 0.0137)
        EXPECT_NEAR(vector_exp(x) / std::exp(x), 1.0, 1e-15);
    EXPECT_NEAR(vector_exp(700.0) / std::exp(700.0), 1.0, 1e-13);
    EXPECT_GT(vector_exp(-800.0), 0.0);
}

TEST(Shapes, biconcave_has_the_published_area_and_perimeter) {
    const std::vector<Vec2> cell = biconcave(3.91, 2000);
    EXPECT_NEAR(area_of(cell), 13.63, 0.01);
    EXPECT_NEAR(perimeter_of(cell), 19.27, 0.01);
}

TEST(Shapes, nodes_stand_at_equal_arc_length) {
    const std::vector<Vec2> cell = ellipse(5.0, 2.0, 200);
    const double mean = perimeter_of(cell) / 200;
    for (int k = 0; k < 200; ++k)
        EXPECT_NEAR(norm(cell[(k + 1) % 200] - cell[k]), mean, 2e-3 * mean);
}

}  // namespace
