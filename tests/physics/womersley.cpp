#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "flow.hpp"
#include "fluid/analytic.hpp"
#include "simulation/advance.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

/// A channel of 20 um whose pressure drop swings about a mean, at the Womersley number
/// α = H/2 √(ω/ν) = 3.
class Womersley : public TemporaryDirectory {
protected:
    static constexpr double height = 20e-6, viscosity = 1.2e-3, density = 1000.0, alpha = 3.0;
    static constexpr double nu = viscosity / density;
    static constexpr double omega = 4.0 * nu * alpha * alpha / (height * height);
    static constexpr double mean = 1e-3;  // m/s

    Case read(const std::string& waveform, int rows, const std::string& more = {}) {
        std::ofstream(path("case.toml")) << fmt::format(
            R"(format = 1
[domain]
length = "{} um"
width = "20 um"
[flow]
drive = "pressure"
mean_velocity = "1 mm/s"
{}
[plasma]
viscosity = "1.2 cP"
density = "1000 kg/m^3"
[numerics]
fluid_only = true
dx = "{} um"
{}
[time]
end = "1 ms"
)",
            4.0 * 20.0 / rows, waveform, 20.0 / rows, more);
        return read_case(path("case.toml"));
    }
    std::string sine() const {
        return fmt::format("waveform = \"sine\"\nfrequency = \"{:.15g} Hz\"\namplitude = 2.0",
                           omega / (2.0 * std::numbers::pi));
    }
    /// Largest error of the velocity over a period, as a share of the largest velocity.
    double error(int rows) {
        const Case c = read(sine(), rows, "relaxation_time = 1.0\ndensity_scale = 1.0");
        Model model = discretise(c);
        State state = initial_state(c, model);
        Periodic exchange;
        const double period = 2.0 * std::numbers::pi / (omega * model.scales.time);
        while (state.step < 6.0 * period) advance(model, state, exchange);
        const double g = 12.0 * nu * mean / (height * height);
        double worst = 0.0, fastest = 0.0;
        while (state.step < 7.0 * period) {
            advance(model, state, exchange);
            // The velocity is that of the populations that this step found.
            const double time = static_cast<double>(state.step - 1) * model.scales.time;
            for (int j = 0; j < rows; ++j) {
                const double y = (j + 0.5) / rows * height;
                const double exact = analytic::poiseuille(y, height, nu, g) +
                                     analytic::womersley(y, height, nu, 2.0 * g, omega, time);
                const double u = state.velocity(1, j).x * model.scales.length / model.scales.time;
                worst = std::max(worst, std::fabs(u - exact));
                fastest = std::max(fastest, std::fabs(exact));
            }
        }
        return worst / fastest;
    }
};

TEST_F(Womersley, flow_converges_at_second_order) {
    const std::vector<double> errors{error(10), error(20), error(40)};
    std::printf("Womersley flow, alpha = 3: errors %.2e %.2e %.2e, order %.3f\n", errors[0],
                errors[1], errors[2], observed_order(errors));
    EXPECT_LT(errors[1], 5e-3);
    EXPECT_GT(observed_order(errors), 1.9);
}

/// The density that `auto` raises leaves the flow time to follow.
TEST_F(Womersley, number_of_the_run_is_near_that_of_the_case) {
    const Case c = read(sine(), 20);
    const Choice choice = choose(c);
    // (S − 1) of the lag 2 f H²/(π ν) is within the tolerance of one part in twenty.
    const double lag =
        2.0 * omega / (2.0 * std::numbers::pi) * height * height / (std::numbers::pi * nu);
    EXPECT_LE((choice.density_scale - 1.0) * lag, c.numerics.step_tolerance * 1.0001);
}

TEST_F(Womersley, table_repeats_and_is_straight_between_its_points) {
    const Case c = read(
        "waveform = \"table\"\ntimes = [\"0 ms\", \"1 ms\", \"4 ms\"]\n"
        "factors = [1.0, 3.0, 0.0]",
        10);
    const Model model = discretise(c);
    const auto at = [&](double ms) {
        return model.drive.waveform.at(ms * 1e-3 / model.scales.time);
    };
    EXPECT_NEAR(at(0.0), 1.0, 1e-12);
    EXPECT_NEAR(at(0.5), 2.0, 1e-12);
    EXPECT_NEAR(at(2.5), 1.5, 1e-12);
    EXPECT_NEAR(at(3.9999999), 0.0, 1e-5);
    EXPECT_NEAR(at(8.5), 2.0, 1e-9);
    EXPECT_EQ(largest_factor(c.flow.waveform), 3.0);
}

TEST_F(Womersley, waveforms_that_mean_nothing_are_refused) {
    const auto refused = [&](const std::string& waveform) {
        try {
            read(waveform, 10);
        } catch (const CaseError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(refused("waveform = \"sine\"").find("frequency"), std::string::npos);
    EXPECT_NE(refused("waveform = \"table\"\ntimes = [\"0 s\", \"0 s\"]\nfactors = [1.0, 2.0]")
                  .find("each later than the one before"),
              std::string::npos);
    EXPECT_NE(refused("waveform = \"table\"\ntimes = [\"0 s\", \"1 s\"]\nfactors = [1.0]")
                  .find("1 factors and 2 times"),
              std::string::npos);
    EXPECT_NE(refused("hold = \"mean-velocity\"\n" + sine()).find("leave hold out"),
              std::string::npos);
}

}  // namespace
}  // namespace tt
