#include <gtest/gtest.h>

#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/read.hpp"
#include "exchange/periodic.hpp"
#include "simulation/advance.hpp"
#include "source_dir.hpp"

using namespace tt;

namespace {

/// The fraction of cytoplasm by one method, sharp, of the cells as they are.
Field<> interior(const InteriorMethod& method, const Model& m, const State& s) {
    ViscosityModel viscosity = m.viscosity;
    viscosity.interior = method;
    viscosity.interface = SharpInterface{};
    InteriorState interior;
    Relaxation relaxation(m.lattice);
    rebuild_viscosity(viscosity, s.cells, interior, relaxation);
    return interior.cytoplasm;
}

class EveryCaseWithCells : public testing::TestWithParam<const char*> {};

TEST_P(EveryCaseWithCells, scan_line_equals_flood_fill_as_it_runs) {
    const Case c = read_case(std::string(TT_SOURCE_DIR "/cases/") + GetParam() + "/case.toml",
                             {"numerics.dx=0.5 um"});
    const Model m = discretise(c);
    State s = initial_state(c, m);
    Periodic ends;
    for (int look = 0; look < 4; ++look) {
        const Field<> by_scan_line = interior(ScanLine{}, m, s);
        const Field<> by_flood_fill = interior(FloodFill{}, m, s);
        double inside = 0.0;
        for (int j = 0; j < m.lattice.ny; ++j) {
            for (int i = 0; i < m.lattice.nx; ++i) {
                ASSERT_EQ(by_scan_line(i, j), by_flood_fill(i, j)) << "site " << i << ", " << j;
                inside += by_scan_line(i, j);
            }
        }
        double area = 0.0;
        for (const double a : s.cells.area) area += a;
        EXPECT_NEAR(inside, area, 0.05 * area);
        for (int step = 0; step < 200; ++step) advance(m, s, ends);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, EveryCaseWithCells,
                         testing::Values("03-cell-in-shear", "04-cell-relaxing", "05-channel"));

}  // namespace
