#include <cmath>

#include <gtest/gtest.h>

#include "io/csv.hpp"
#include "io/frames.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {
namespace {

using CellsKept = TemporaryDirectory;

/// No cell is removed, clipped or capped without a word: all are in every row and in every frame,
/// with all their nodes and their area, and no limiter has acted.
TEST_F(CellsKept, every_cell_is_in_every_row_and_frame_with_its_area) {
    const State start = small_state(small_model());
    const int cells = start.cells.cell_count(), nodes = start.cells.node_count();
    run_small(small_request(path("run"), 400));

    const Table table = read_csv(path("run") / "cells.csv");
    const Table series = read_csv(path("run") / "series.csv");
    const std::size_t looks = series.column("time").size();
    EXPECT_EQ(looks, 41u);
    ASSERT_EQ(table.column("cell").size(), looks * static_cast<std::size_t>(cells));
    for (std::size_t row = 0; row < table.column("cell").size(); ++row) {
        EXPECT_EQ(table.column("cell")[row], static_cast<double>(row % cells));
        EXPECT_LT(std::abs(table.column("area_error")[row]), 1e-4) << "row " << row;
    }
    for (const double count : series.column("repulsion_count")) EXPECT_EQ(count, 0.0);

    const FramesReader frames(path("run") / "frames.h5");
    ASSERT_EQ(frames.count(), 17);
    EXPECT_EQ(frames.header().first, start.cells.first);
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.frame(k);
        ASSERT_EQ(frame.nodes.size(), 2u * static_cast<std::size_t>(nodes));
        for (const double x : frame.nodes) EXPECT_TRUE(std::isfinite(x));
    }
}

}  // namespace
}  // namespace tt
