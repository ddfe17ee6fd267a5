#include "case/initial_state.hpp"

#include <gtest/gtest.h>

#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/read.hpp"
#include "observe/cell_measures.hpp"
#include "observe/run_measures.hpp"
#include "source_dir.hpp"

namespace tt {
namespace {

TEST(InitialState, cells_of_a_developed_flow_move_with_it_before_the_first_step) {
    const Case c = read_case(TT_SOURCE_DIR "/cases/05-channel/case.toml", {"numerics.dx=0.4 um"});
    const Model model = discretise(c, choose(c));
    const State state = initial_state(c, model);
    const std::vector<CellMeasures> cells = measure_cells(model, state);
    const double height = 20e-6, mean = 500.0 * height, radius = 4e-6;
    double carried = 0.0, area = 0.0;
    for (const CellMeasures& cell : cells) {
        // The mean of the parabola over a disc: ⟨y²⟩ = y_c² + a²/4.
        const double y = cell.y.si / height;
        const double exact =
            6.0 * mean * (y * (1.0 - y) - 0.25 * radius * radius / (height * height));
        EXPECT_NEAR(cell.velocity.si / exact, 1.0, 0.01);
        carried += cell.area.si * exact;
        area += cell.area.si;
    }
    const RunMeasures run = measure_run(model, state, cells);
    EXPECT_NEAR(run.hematocrit_discharge / run.hematocrit_tube / (carried / area / mean), 1.0,
                0.01);
}

}  // namespace
}  // namespace tt
