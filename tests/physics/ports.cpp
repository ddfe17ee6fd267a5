#include "fluid/ports.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "case/choose.hpp"
#include "case/port_figures.hpp"
#include "case/read.hpp"
#include "flow.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

constexpr int length = 60, width = 20, margin = 2;

/// A straight channel between two openings.
Flow channel(double tau, const Equilibrium& equilibrium, PortCondition left, PortCondition right) {
    Solid solid;
    solid.outside = true;
    const double x0 = margin, x1 = margin + length, y0 = margin, y1 = margin + width;
    solid.loops = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    solid.openings = {{{x0, y0}, {x0, y1}}, {{x1, y0}, {x1, y1}}};
    const Lattice lattice{length + 2 * margin, width + 2 * margin, false};
    Flow flow(lattice);
    flow.equilibrium = equilibrium;
    flow.boundaries.walls = std::make_shared<const Walls>(make_walls(solid, lattice));
    flow.boundaries.ports = {left, right};
    flow.set_viscosity([&](int) { return (tau - 0.5) / 3.0; });
    return flow;
}

/// Steps until what is left of a start from rest is rounding: momentum has spread across, and
/// density has spread along, 6 (τ − ½) (L/H)² steps.
long long enough(double tau) {
    const double across = width * width * 3.0 / (9.87 * (tau - 0.5));
    const double along = 6.0 * (tau - 0.5) * length * length / (width * width);
    return static_cast<long long>(45.0 * (across + along)) + 1000;
}

struct Seen {
    double flow_rate = 0.0, drop = 0.0;    ///< of two steps; p(left) − p(right)
    double profile = 0.0, sideways = 0.0;  ///< largest errors over the mean velocity
    double balance = 0.0;                  ///< sum over the ports, over the flow rate
};

Seen seen_in(Flow& flow, double tau) {
    flow.run(enough(tau));
    VectorField<> mean = flow.velocity;
    flow.run(1);
    Seen seen;
    seen.flow_rate = flow.ports[0].mean_inflow();
    seen.drop = (flow.ports[0].mean_density() - flow.ports[1].mean_density()) / 3.0;
    seen.balance = (flow.ports[0].mean_inflow() + flow.ports[1].mean_inflow()) / seen.flow_rate;
    const double speed = seen.flow_rate / width;
    for (int j = 0; j < width; ++j) {
        const double eta = (j + 0.5) / width;
        // The mean of a parabola over a site less its value there: 2 U (Δ/H)² / 4.
        const double exact = speed * (6.0 * eta * (1.0 - eta));
        for (int i = 0; i < length; ++i) {
            const Vec2 u =
                0.5 * (mean(i + margin, j + margin) + flow.velocity(i + margin, j + margin));
            seen.profile = std::max(seen.profile, std::abs(u.x - exact) / speed);
            seen.sideways = std::max(seen.sideways, std::abs(u.y) / speed);
        }
    }
    return seen;
}

/// Q = Δp H³ / (12 ν L), as the sum over the sites across, which is 1 + 1/(2 H²) of the integral.
double exact_flow(double drop, double tau) {
    const double sampled = 1.0 + 0.5 / (width * width);
    return sampled * drop * std::pow(width, 3) / (12.0 * (tau - 0.5) / 3.0 * length);
}

TEST(Ports, pressure_drives_poiseuille_flow_to_rounding_at_any_relaxation_time) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        const double density = 1e-4 * (tau - 0.5);
        Flow flow = channel(tau, LinearEquilibrium{}, HeldDensity{density}, HeldDensity{0.0});
        const Seen seen = seen_in(flow, tau);
        EXPECT_NEAR(seen.flow_rate / exact_flow(density / 3.0, tau), 1.0, 1e-6) << tau;
        EXPECT_LT(seen.sideways, 1e-6) << tau;
        EXPECT_LT(std::abs(seen.balance), 1e-10) << tau;
    }
}

TEST(Ports, a_held_inflow_is_met_and_takes_the_pressure_of_poiseuille_flow) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        const double inflow = 0.1;
        Flow flow = channel(tau, LinearEquilibrium{}, HeldInflow{inflow}, HeldDensity{0.0});
        const Seen seen = seen_in(flow, tau);
        EXPECT_NEAR(seen.flow_rate / inflow, 1.0, 1e-12) << tau;
        EXPECT_NEAR(exact_flow(seen.drop, tau) / inflow, 1.0, 1e-6) << tau;
        EXPECT_LT(std::abs(seen.balance), 1e-10) << tau;
    }
}

/// u_n² at a port is that of its sites, half a spacing inside.
TEST(Ports, inertia_changes_the_flow_little) {
    for (const double tau : {0.6, 1.5, 5.5}) {
        const double density = 0.02 * (tau - 0.5);
        Flow flow =
            channel(tau, IncompressibleEquilibrium{}, HeldDensity{density}, HeldDensity{0.0});
        const Seen seen = seen_in(flow, tau);
        EXPECT_NEAR(seen.flow_rate / exact_flow(density / 3.0, tau), 1.0, 2e-3) << tau;
        EXPECT_LT(seen.sideways, 1e-2) << tau;
        EXPECT_LT(std::abs(seen.balance), 1e-10) << tau;
    }
}

/// A value of tests/reference/stokes_networks.csv.
double reference(const std::string& start) {
    std::ifstream file(TT_SOURCE_DIR "/tests/reference/stokes_networks.csv");
    for (std::string line; std::getline(file, line);)
        if (line.rfind(start, 0) == 0) return std::stod(line.substr(start.size()));
    ADD_FAILURE() << start;
    return 0.0;
}

/// G = Q μ/Δp [µm²] of each port, out of the channels, where one port alone is under pressure.
std::vector<double> conductances(const std::string& folder, const std::string& file,
                                 const std::array<const char*, 3>& at, int under_pressure,
                                 const std::string& dx) {
    std::string text = fmt::format(
        "format = 1\n[geometry]\nshape = \"file\"\nfile = \"{}\"\n[numerics]\n"
        "fluid_only = true\ndx = \"{}\"\n[time]\nend = \"1 ms\"\n",
        file, dx);
    for (int n = 0; n < 3; ++n)
        text += fmt::format("[port.p{}]\nat = {}\npressure = \"{} Pa\"\n", n, at[n],
                            n == under_pressure ? 100 : 0);
    const Case c = parse_case(text, "test", {}, std::string(TT_SOURCE_DIR) + folder);
    const Choice choice = choose(c);
    std::vector<double> values;
    for (std::size_t n = 0; n < 3; ++n)
        values.push_back(-figures_of(c, choice, n).flow_rate.si * c.plasma.viscosity.si / 100.0 *
                         1e12);
    return values;
}

constexpr std::array fork_files{R"(["0 um", "0 um"])", R"(["170 um", "-36 um"])",
                                R"(["170 um", "33 um"])"};
constexpr std::array junction{R"(["0 um", "9 um"])", R"(["66 um", "-50 um"])",
                              R"(["67 um", "70 um"])"};

// With 17 sites in the narrowest branch.
TEST(Networks, flow_of_plasma_through_a_fork) {
    const auto by_inlet = conductances("/cases/07-fork", "fork.csv", fork_files, 0, "0.5 um");
    const std::string start = "y_bifurcation,G ";
    EXPECT_NEAR(by_inlet[0] / reference(start + "inlet when dp is at the inlet,um^2,"), 1.0, 0.005);
    EXPECT_NEAR(by_inlet[1] / reference(start + "lower when dp is at the inlet,um^2,"), 1.0, 0.005);
    EXPECT_NEAR(by_inlet[2] / reference(start + "upper when dp is at the inlet,um^2,"), 1.0, 0.005);
    const auto by_lower = conductances("/cases/07-fork", "fork.csv", fork_files, 1, "0.5 um");
    EXPECT_NEAR(by_lower[1] / reference(start + "lower when dp is at the lower port,um^2,"), 1.0,
                0.005);
    // An eighth of what comes in: as much of it is 0.1 % of the whole.
    EXPECT_NEAR(by_lower[2] / reference(start + "upper when dp is at the lower port,um^2,"), 1.0,
                0.008);
}

// Its corners are singular: any scheme is of first order there, and 40 sites across give 0.6 %.
TEST(Networks, flow_of_plasma_through_a_t_junction) {
    const std::string start = "t_junction,G ";
    double coarse = 0.0, fine = 0.0;
    for (const auto& [dx, worst] : {std::pair("1 um", &coarse), std::pair("0.5 um", &fine)}) {
        const auto by_inlet =
            conductances("/tests/fixtures/networks", "t_junction.csv", junction, 0, dx);
        const auto off = [&, w = worst](double value, const std::string& of) {
            *w = std::max(*w, std::abs(value / reference(start + of) - 1.0));
        };
        off(by_inlet[0], "inlet when dp is at the inlet,um^2,");
        off(by_inlet[1], "lower when dp is at the inlet,um^2,");
        off(by_inlet[2], "upper when dp is at the inlet,um^2,");
    }
    EXPECT_LT(fine, 0.006);
    EXPECT_LT(fine, 0.6 * coarse);
}

/// The same channels turned by a quarter, mirrored, and in another unit.
TEST(Networks, turned_and_mirrored_channels_have_the_same_flow) {
    const auto straight =
        conductances("/tests/fixtures/networks", "t_junction.csv", junction, 0, "1 um");
    const auto turned = conductances(
        "/tests/fixtures/networks", "t_junction_turned.csv",
        {R"(["-9 um", "0 um"])", R"(["50 um", "66 um"])", R"(["-70 um", "67 um"])"}, 0, "1 um");
    const auto mirrored = conductances(
        "/tests/fixtures/networks", "t_junction_mirrored.csv",
        {R"(["0 um", "9 um"])", R"(["-66 um", "-50 um"])", R"(["-67 um", "70 um"])"}, 0, "1 um");
    for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_NEAR(turned[n] / straight[n], 1.0, 1e-4);
        EXPECT_NEAR(mirrored[n] / straight[n], 1.0, 1e-4);
    }
}

}  // namespace
}  // namespace tt
