#include "fluid/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "flow.hpp"
#include "observe/cell_measures.hpp"
#include "simulation/advance.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

constexpr double pi = std::numbers::pi;

Loop circle_of(Vec2 centre, double radius) {
    Loop loop;
    const int points = 720;
    // Of the same area as the circle.
    const double corner = radius * std::sqrt(2.0 * pi / points / std::sin(2.0 * pi / points));
    for (int k = 0; k < points; ++k) {
        const double angle = 2.0 * pi * k / points;
        loop.push_back(centre + corner * Vec2{std::cos(angle), std::sin(angle)});
    }
    return loop;
}

Flow flow_with(const Walls& walls, double tau) {
    Flow flow(walls.lattice);
    flow.boundaries.walls = std::make_shared<const Walls>(walls);
    flow.set_viscosity([&](int) { return (tau - 0.5) / 3.0; });
    return flow;
}

/// The mean of two steps: what a lattice conserves besides momentum changes sign from one to the
/// next.
VectorField<> steady(Flow& flow, long long steps) {
    flow.run(steps);
    VectorField<> mean = flow.velocity;
    flow.run(1);
    for (std::size_t n = 0; n < mean.x.size(); ++n) {
        mean.x.data()[n] = 0.5 * (mean.x.data()[n] + flow.velocity.x.data()[n]);
        mean.y.data()[n] = 0.5 * (mean.y.data()[n] + flow.velocity.y.data()[n]);
    }
    return mean;
}

/// L2 error of the flow between a turning outer ring and a resting inner one of half its radius.
double couette_error(double outer, double tau) {
    const int size = 2 * static_cast<int>(outer) + 6;
    const double inner = 0.5 * outer;
    const Vec2 centre{0.5 * size + 0.13, 0.5 * size - 0.21};
    Solid solid;
    solid.outside = true;
    solid.loops = {circle_of(centre, outer), circle_of(centre, inner)};
    Walls walls = make_walls(solid, Lattice{size, size, false});
    const double spin = 0.02 / outer;
    for (WallLink& link : walls.links) {
        const Vec2 at =
            Lattice::position(link.i, link.j) -
            link.q * Vec2{double(d2q9::cx[link.direction]), double(d2q9::cy[link.direction])} -
            centre;
        if (link.loop == 0) link.velocity = spin * Vec2{-at.y, at.x};
    }
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0;
    const VectorField<> u =
        steady(flow, 500 + static_cast<long long>(3.0 * outer * outer / viscosity));
    const double a = spin * outer * outer / (outer * outer - inner * inner);
    double error = 0.0, total = 0.0;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            if (!walls.is_open(i, j)) continue;
            const Vec2 r = Lattice::position(i, j) - centre;
            const double turn = a * (1.0 - inner * inner / dot(r, r));
            const Vec2 exact = turn * Vec2{-r.y, r.x};
            const Vec2 off = u(i, j) - exact;
            error += dot(off, off);
            total += dot(exact, exact);
        }
    return std::sqrt(error / total);
}

TEST(Walls, circular_couette_flow_is_second_order_at_any_relaxation_time) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        const double coarse = couette_error(10.0, tau), fine = couette_error(20.0, tau);
        EXPECT_LT(fine, 3e-3) << tau;
        EXPECT_GT(std::log2(coarse / fine), 1.9) << coarse << " " << fine;
    }
}

/// A channel that climbs by `rise` over the `length` of its period: a box of `length` columns and
/// `rise` rows is periodic both ways, and holds as many pieces of the channel as fit one above the
/// other. Flow rate over the exact one, less 1.
double inclined_error(int length, int rise, double height, double offset, double tau) {
    const double secant = std::hypot(length, rise) / length;
    const double half = 0.5 * height * secant;  // along y
    // Rows: a multiple of the rise with room for the channel and a wall of some sites.
    const int turns = static_cast<int>(std::ceil((2.0 * half + 8.0) / rise));
    const int ny = turns * rise;
    Solid solid;
    solid.outside = true;
    solid.period_x = length * turns;
    solid.period_y = ny;
    const double far = length * turns;
    const auto middle = [&](double x) { return offset + x * rise / length; };
    solid.loops = {{{0.0, middle(0.0) - half},
                    {far, middle(far) - half},
                    {far, middle(far) + half},
                    {0.0, middle(0.0) + half}}};
    const Walls walls = make_walls(solid, Lattice{length * turns, ny, false});
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0, force = 1e-6;
    flow.body_force = force / secant * Vec2{1.0, static_cast<double>(rise) / length};
    const VectorField<> u =
        steady(flow, 1000 + static_cast<long long>(3.0 * height * height / viscosity));
    // Along the channel, over all of its length; every column holds one period's worth of it.
    double sum = 0.0;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i)
            sum += (u.x(i, j) + u.y(i, j) * rise / length) / secant;
    const double flux = sum / (walls.lattice.nx * secant);
    return flux / (force * height * height * height / (12.0 * viscosity)) - 1.0;
}

TEST(Walls, flow_in_inclined_channels) {
    struct Slope {
        int length, rise;
    };
    for (const Slope slope : {Slope{5, 1}, Slope{3, 1}, Slope{2, 1}, Slope{1, 1}}) {
        for (const double offset : {0.0, 0.37}) {
            const double usual = inclined_error(slope.length, slope.rise, 20.0, offset, 1.5);
            EXPECT_LT(std::abs(usual), 0.005) << slope.length << " " << offset;
            for (const double tau : {0.6, 5.5})
                EXPECT_NEAR(inclined_error(slope.length, slope.rise, 20.0, offset, tau), usual,
                            1e-3)
                    << tau;
        }
    }
}

/// K of Darcy's law for a square array of posts of this radius, times viscosity over force, against
/// drag: F/(μ U) = L²/K.
double array_drag(int size, double share, double tau, Vec2 centre) {
    Solid solid;
    solid.loops = {circle_of(centre, size * std::sqrt(share / pi))};
    solid.period_x = solid.period_y = size;
    const Walls walls = make_walls(solid, Lattice{size, size, false});
    Flow flow = flow_with(walls, tau);
    const double viscosity = (tau - 0.5) / 3.0, force = 1e-6, area = size * size;
    flow.body_force = {force, 0.0};
    const VectorField<> u = steady(flow, static_cast<long long>(area / viscosity));
    return force * area * area / (viscosity * sum_over_sites(u.x));
}

/// F/(μ U) of Sangani and Acrivos (1982); confirmed by finite elements, see
/// tests/reference/stokes_networks.csv. The gaps are 20 and 8 sites wide in boxes of 40.
TEST(Walls, drag_of_square_arrays_of_posts) {
    struct Array {
        double share, drag, bound;
    };
    for (const Array a : {Array{0.2, 51.527, 0.006}, Array{0.5, 532.55, 0.018}}) {
        double coarse = 0.0, fine = 0.0;
        for (const Vec2 centre : {Vec2{0.0, 0.0}, Vec2{0.5, 0.5}, Vec2{0.31, 0.27}}) {
            const double usual = array_drag(40, a.share, 1.5, centre) / a.drag - 1.0;
            EXPECT_LT(std::abs(usual), a.bound) << centre.x;
            for (const double tau : {0.6, 5.5})
                EXPECT_NEAR(array_drag(40, a.share, tau, centre) / a.drag - 1.0, usual, 1e-6)
                    << tau;
            coarse = std::max(coarse, std::abs(usual));
            fine = std::max(fine, std::abs(array_drag(80, a.share, 1.5, centre) / a.drag - 1.0));
        }
        EXPECT_GT(std::log2(coarse / fine), 1.9);
    }
}

/// Flow rate times viscosity over force of plasma alone, µm³, of a case with this [geometry].
double conductance_of(const std::string& domain, const std::string& geometry, double spacing) {
    const Case c =
        parse_case(fmt::format("format = 1\n[domain]\n{}\n[geometry]\n{}\n[flow]\ndrive = "
                               "\"body-force\"\nmean_velocity = \"1 mm/s\"\n[numerics]\n"
                               "fluid_only = true\ndx = \"{} um\"\n[time]\nend = \"1 ms\"\n",
                               domain, geometry, spacing),
                   "test");
    return choose(c).undisturbed->conductance * std::pow(spacing, 3);
}

/// A value of tests/reference/stokes_networks.csv.
double reference(const std::string& start) {
    std::ifstream file(TT_SOURCE_DIR "/tests/reference/stokes_networks.csv");
    for (std::string line; std::getline(file, line);)
        if (line.rfind(start, 0) == 0) return std::stod(line.substr(start.size()));
    ADD_FAILURE() << start;
    return 0.0;
}

// With 16 sites in the narrowest gap. A piece of channel between two ports, G = Q μ/Δp, is a period
// of a channel driven by the force Δp/L.
TEST(Walls, flow_through_a_stenosis_around_posts_and_arrays_of_them) {
    const std::string channel = "width = \"20 um\"\nlength = ";
    const std::string throat = "shape = \"stenosis\"\nthroat = \"8 um\"\nthroat_length = \"60 um\"";
    EXPECT_NEAR(conductance_of(channel + "\"120 um\"", throat, 0.5) /
                    (120.0 * reference("stenosis,G,um^2,")),
                1.0, 0.005);
    EXPECT_NEAR(
        conductance_of(channel + "\"80 um\"", "shape = \"posts\"\ndiameter = \"10 um\"", 0.3125) /
            (80.0 * reference("cylinder_centred,G,um^2,")),
        1.0, 0.005);
    const std::string array = "width = \"24 um\"\nsides = \"periodic\"\nlength = ";
    const std::string posts = "shape = \"posts\"\ndiameter = \"14 um\"\n";
    EXPECT_NEAR(
        conductance_of(array + "\"24 um\"", posts, 0.6) / (24.0 * reference("post_array,K,um^2,")),
        1.0, 0.007);
    // Posts whose columns climb turn the flow aside unless something acts against it.
    EXPECT_NEAR(
        conductance_of(array + "\"240 um\"", posts + "columns = 10\nrow_shift = 0.1", 0.6) /
            (24.0 * reference("dld_cell,mean velocity along x times mu over g_x with no mean "
                              "flow across,um^2,")),
        1.0, 0.007);
}

/// Where a capsule is, and how stretched.
struct Passage {
    double x, time, lambda_C;
};

/// A capsule of 4 µm from x = 20 µm through the throat, at a mean velocity of 2 mm/s, by the
/// centroid's way.
std::vector<Passage> passage(double until) {
    const Case c = parse_case(R"(format = 1
[domain]
length = "120 um"
width = "20 um"
[geometry]
shape = "stenosis"
throat = "8 um"
throat_length = "60 um"
[flow]
drive = "pressure"
mean_velocity = "2 mm/s"
hold = "mean-velocity"
[cells]
layout = "explicit"
positions = [["20 um", "10 um"]]
cytoplasm_viscosity = "1.2 cP"
[membrane.hardening]
apply_to = []
[contact]
model = "none"
[numerics]
dx = "0.5 um"
step_tolerance = "0.5 %"
[time]
end = "20 ms"
)",
                              "capsule");
    const Model model = discretise(c, choose(c));
    State state = initial_state(c, model);
    Periodic ends;
    std::vector<Passage> way;
    while (way.empty() || way.back().x < until) {
        for (int k = 0; k < 20; ++k) advance(model, state, ends);
        const CellMeasures m = measure_cell(model, state, 0);
        way.push_back(
            {m.x.si * 1e6, static_cast<double>(state.step) * model.scales.time, m.lambda_C});
    }
    return way;
}

double at(const std::vector<Passage>& way, double x, double Passage::*what) {
    const auto after =
        std::find_if(way.begin(), way.end(), [&](const Passage& p) { return p.x >= x; });
    const Passage &a = *(after - 1), &b = *after;
    const double share = (x - a.x) / (b.x - a.x);
    return (1.0 - share) * a.*what + share * b.*what;
}

// Of boundary integrals, tests/reference/capsule_stenosis.csv, with eight sites to the radius: to
// where it is narrowest. What then compresses the membrane is finer than this grid.
TEST(Walls, a_capsule_is_drawn_into_a_throat_as_by_boundary_integrals) {
    const std::vector<Passage> way = passage(60.5);
    const double start = at(way, 30.0, &Passage::time);
    struct Station {
        double x, time, lambda_C;
    };
    for (const Station s : {Station{40, 0.003274, 1.12111}, Station{50, 0.005667, 1.35265},
                            Station{55, 0.006542, 1.47557}, Station{60, 0.007327, 1.51641}}) {
        EXPECT_NEAR((at(way, s.x, &Passage::time) - start) / s.time, 1.0, 0.008) << s.x;
        EXPECT_NEAR(at(way, s.x, &Passage::lambda_C) / s.lambda_C, 1.0, 0.01) << s.x;
    }
}

}  // namespace
}  // namespace tt
