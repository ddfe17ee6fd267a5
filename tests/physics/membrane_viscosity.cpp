#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "observe/cell_measures.hpp"
#include "source_dir.hpp"
#include "verify/cell.hpp"

namespace tt {
namespace {

/// The cell of the references, radius 4 µm, in a channel 20 µm wide and 80 µm long at `sites` to
/// the radius.
Case cell_in_narrow_channel(double ratio, double bq, double sites) {
    Case c = capsule_case(1);
    c.domain = {Length{80e-6}, Length{20e-6}};
    c.cells.cytoplasm_viscosity.si = ratio * c.plasma.viscosity.si;
    c.membrane.membrane_viscosity.si = bq * c.plasma.viscosity.si * 4e-6;
    c.numerics.dx = Length{4e-6 / sites};
    c.numerics.density_scale.reset();
    c.numerics.step_tolerance = 2e-3;
    return c;
}

/// The numbers of the row of a reference that begins like this.
std::vector<double> row_of(const char* name, const std::string& beginning) {
    std::ifstream file(std::string(TT_SOURCE_DIR "/tests/reference/") + name);
    for (std::string line; std::getline(file, line);) {
        if (line.rfind(beginning + ",", 0) != 0) continue;
        std::vector<double> numbers;
        std::istringstream rest(line.substr(beginning.size() + 1));
        for (std::string number; std::getline(rest, number, ',');)
            numbers.push_back(std::stod(number));
        return numbers;
    }
    ADD_FAILURE() << "no row " << beginning;
    return {};
}

TEST(MembraneViscosity, slows_the_start_of_shear_as_the_reference_says) {
    for (const double bq : {20.0, 100.0}) {
        Experiment shear(cell_in_narrow_channel(1.0, bq, 10.0));
        for (const double kt : {1.0, 3.0}) {
            shear.advance_to_strain(kt);
            const CellMeasures cell = measure_cell(shear.model, shear.state, 0);
            const std::vector<double> row = row_of("membrane_viscosity_startup.csv",
                                                   fmt::format("channel20,1,0.2,{},{}", bq, kt));
            ASSERT_EQ(row.size(), 5u);
            const double D = row[0], strain = row[2];
            std::printf("Bq %g, k t %g: D %.4f (%.4f), strain %.4f (%.4f)\n", bq, kt,
                        cell.taylor_inertia, D, cell.strain, strain);
            EXPECT_NEAR(cell.taylor_inertia / D, 1.0, 0.01);
            EXPECT_NEAR(cell.strain / strain, 1.0, 0.02);
        }
    }
}

/// The cell drawn out to 1.5 : 1 in fluid at rest: the difference of its stretches falls as
/// exp(−t/τ), τ = (η_m + (μ_out + μ_in) a)/(3 E_s).
TEST(MembraneViscosity, slows_the_recoil_by_its_own_time) {
    for (const auto& [ratio, bq] : {std::pair{1, 20}, std::pair{5, 5}}) {
        Case c = cell_in_narrow_channel(ratio, bq, 12.5);
        c.domain = {Length{64e-6}, Length{64e-6}};
        c.flow.drive = NoDrive{};
        c.cells.initial_stretch = 1.5;
        Experiment recoil(c);
        const std::vector<double> row =
            row_of("membrane_viscosity_recoil.csv", fmt::format("{},{}", ratio, bq));
        ASSERT_EQ(row.size(), 7u);
        const double unit = c.plasma.viscosity.si * 4e-6 / c.membrane.shear_modulus.si;
        const auto spread = [&] {
            const CellMeasures cell = measure_cell(recoil.model, recoil.state, 0);
            return cell.stretch_max - cell.stretch_min;
        };
        const double start = spread();
        const auto step =
            static_cast<std::int64_t>(0.02 * row[1] * unit / recoil.model.scales.time);
        double before = start, time = 0.0;
        while (spread() > start / std::exp(1.0) && time < 3.0 * row[1]) {
            before = spread();
            recoil.advance_by(step);
            time = recoil.time() * recoil.model.scales.time / unit;
        }
        const double now = spread(), each = step * recoil.model.scales.time / unit;
        const double found =
            time - each * std::log(start / std::exp(1.0) / now) / std::log(before / now);
        std::printf("ratio %d, Bq %d: recoil in %.3f (%.3f)\n", ratio, bq, found, row[1]);
        EXPECT_NEAR(found / row[1], 1.0, 0.01);
    }
}

/// What a viscosity of bending changes, extrapolated in (a/H)² from walls 10 and 20 radii apart to
/// none: the numbers of docs/theory/membrane-viscosity.md.
TEST(MembraneViscosity, of_bending_lessens_inclination_and_deformation) {
    const auto steady = [](double width, double bb) {
        Case c = capsule_case(1);
        const double a = 4e-6;
        c.domain.width = Length{width};
        c.numerics.density_scale = 100.0;
        c.membrane.bending_viscosity.si = bb * c.plasma.viscosity.si * a * a * a;
        return tank_treading(c, 8.0);
    };
    const auto change = [&](double width) {
        const TankTreading plain = steady(width, 0.0), viscous = steady(width, 0.3);
        return TankTreading{viscous.taylor / plain.taylor,
                            viscous.inclination_deg - plain.inclination_deg, 0.0,
                            viscous.period / plain.period};
    };
    const TankTreading near = change(40e-6), far = change(80e-6);
    const auto unbounded = [&](double TankTreading::*number) {
        return far.*number + (far.*number - near.*number) / 3.0;
    };
    const double taylor = unbounded(&TankTreading::taylor),
                 inclination = unbounded(&TankTreading::inclination_deg),
                 period = unbounded(&TankTreading::period);
    std::printf("Bb = 0.3: D times %.4f, inclination %+.2f deg, k T times %.4f\n", taylor,
                inclination, period);
    EXPECT_NEAR(taylor, 0.401 / 0.423, 0.005);
    EXPECT_NEAR(inclination, 20.0 - 23.9, 0.4);
    EXPECT_NEAR(period, 20.30 / 18.18, 0.01);
}

}  // namespace
}  // namespace tt
