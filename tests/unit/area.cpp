#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "membrane/area.hpp"
#include "membrane/outline.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

double area(const Suspension& cells) {
    std::vector<Vec2> points;
    for (int k = 0; k < cells.node_count(); ++k) points.push_back(cells.position(k));
    return area_of(points);
}

/// A cell of the area given, relative to its reference, with random velocities.
Suspension moving_cell(double area_ratio) {
    Suspension cells;
    add_cell(cells, placed(ellipse(14.0, 6.0, 90), 0.7, {310.5, 20.25}));
    size_derived(cells);
    cells.area = {area(cells)};
    cells.perimeter = {perimeter(outline(cells, 0))};
    cells.reference_area[0] = cells.area[0] / area_ratio;
    Random random(3);
    for (int k = 0; k < cells.node_count(); ++k) {
        cells.ux[k] = 0.03 + random.uniform(-1e-3, 1e-3);
        cells.uy[k] = random.uniform(-1e-3, 1e-3);
    }
    return cells;
}

double area_after_move(Suspension cells) {
    for (int k = 0; k < cells.node_count(); ++k) {
        cells.x[k] += cells.ux[k];
        cells.y[k] += cells.uy[k];
    }
    return area(cells);
}

TEST(HoldArea, a_cell_of_the_right_area_keeps_it) {
    Suspension cells = moving_cell(1.0);
    const double before = cells.area[0];
    EXPECT_GT(std::abs(area_after_move(cells) / before - 1.0), 1e-6);
    hold_area(cells, 0);
    EXPECT_NEAR(area_after_move(cells) / before, 1.0, 1e-8);
}

TEST(HoldArea, an_error_is_undone_by_a_thousandth_a_step) {
    for (const double ratio : {0.99, 1.02}) {
        Suspension cells = moving_cell(ratio);
        hold_area(cells, 0);
        const double error = area_after_move(cells) / cells.reference_area[0] - 1.0;
        EXPECT_NEAR(error / (ratio - 1.0), 0.999, 1e-5);
    }
}

TEST(HoldArea, only_the_normal_velocity_changes_and_as_the_arc_of_the_node) {
    Suspension cells = moving_cell(0.999);
    const Suspension before = cells;
    hold_area(cells, 0);
    const auto moved = [&](int k) { return cells.velocity(k) - before.velocity(k); };
    const auto chord = [&](int k) { return cells.position(k + 1) - cells.position(k - 1); };
    const double per_arc = norm(moved(1)) / norm(chord(1));
    EXPECT_GT(per_arc, 0.0);
    for (int k = 1; k + 1 < cells.node_count(); ++k) {
        EXPECT_NEAR(norm(moved(k)) / norm(chord(k)), per_arc, 1e-12);
        EXPECT_NEAR(dot(moved(k), chord(k)), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace tt
