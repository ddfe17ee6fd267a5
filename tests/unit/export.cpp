#include "report/export.hpp"

#include <cstdint>
#include <cstring>
#include <regex>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/csv.hpp"
#include "report/frames.hpp"
#include "unit/invented_results.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// A block of a file with raw appended data: its name and bytes, found through its offset as a
/// reader finds it.
struct Block {
    std::string name;
    std::string bytes;
};

std::vector<Block> blocks_of(const fs::path& path) {
    const std::string text = text_of(path);
    const std::size_t mark = text.find("<AppendedData encoding=\"raw\">\n_");
    if (mark == std::string::npos) return {};
    const std::size_t start = text.find('_', mark) + 1;
    const std::string head = text.substr(0, mark);
    std::vector<Block> blocks;
    static const std::regex array("Name=\"([^\"]*)\"[^>]*offset=\"([0-9]+)\"");
    std::size_t expected = 0;
    for (std::sregex_iterator match(head.begin(), head.end(), array), end; match != end; ++match) {
        const std::size_t offset = std::stoul((*match)[2]);
        EXPECT_EQ(offset, expected) << "blocks follow each other without a gap";
        std::uint64_t size = 0;
        std::memcpy(&size, text.data() + start + offset, sizeof size);
        blocks.push_back({(*match)[1], text.substr(start + offset + sizeof size, size)});
        expected = offset + sizeof size + size;
    }
    EXPECT_EQ(text.substr(start + expected), "\n</AppendedData>\n</VTKFile>\n");
    return blocks;
}

template <class T>
std::vector<T> values(const std::vector<Block>& blocks, const std::string& name) {
    for (const Block& block : blocks)
        if (block.name == name) {
            std::vector<T> result(block.bytes.size() / sizeof(T));
            std::memcpy(result.data(), block.bytes.data(), block.bytes.size());
            return result;
        }
    ADD_FAILURE() << "no array " << name;
    return {};
}

TEST(ExportVtk, blocks_stand_where_the_offsets_say_and_hold_the_frame) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 3");
    export_vtk(scratch / "run", scratch / "vtk");
    const FramesReader frames((scratch / "run") / "frames.h5");
    const FramesHeader& grid = frames.header();
    const Frame frame = frames.frame(2);

    const auto flow = blocks_of(scratch / "vtk" / "flow" / "flow_000002.vti");
    const auto velocity = values<float>(flow, "velocity [mm/s]");
    ASSERT_EQ(velocity.size(), 3 * static_cast<std::size_t>(grid.nx) * grid.ny);
    EXPECT_FLOAT_EQ(velocity[3 * 41], 1e3f * frame.velocity[2 * 41]);
    EXPECT_EQ(values<float>(flow, "cytoplasm fraction"), frame.cytoplasm);

    const auto cells = blocks_of(scratch / "vtk" / "cells" / "cells_000002.vtp");
    const auto points = values<double>(cells, "Points");
    ASSERT_EQ(points.size(), 3 * frame.nodes.size() / 2);
    EXPECT_DOUBLE_EQ(points[1], 1e6 * frame.nodes[1]);
    EXPECT_EQ(values<std::int64_t>(cells, "offsets").back(), grid.first.back());
    EXPECT_EQ(values<std::int64_t>(cells, "connectivity").size(), frame.nodes.size() / 2);
    EXPECT_EQ(values<double>(cells, "node force [N/m]").size(), points.size());
    EXPECT_EQ(values<double>(cells, "stretch since the first frame").size(),
              frame.nodes.size() / 2);

    const std::string index = text_of(scratch / "vtk" / "cells.pvd");
    EXPECT_NE(index.find("timestep=\"80\" part=\"0\" file=\"cells/cells_000002.vtp\""),
              std::string::npos);
}

TEST(ExportCsv, tables_hold_the_frames) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 2");
    export_csv(scratch / "run", scratch / "csv");
    const FramesReader frames((scratch / "run") / "frames.h5");
    const Table index = read_csv(scratch / "csv" / "frames.csv");
    EXPECT_DOUBLE_EQ(index.column("time")[1], 80e-3);
    const Table nodes = read_csv(scratch / "csv" / "nodes_000001.csv");
    EXPECT_EQ(nodes.rows(), static_cast<std::size_t>(frames.header().first.back()));
    EXPECT_NEAR(nodes.column("x")[7], frames.frame(1).nodes[2 * 7], 1e-13);
    EXPECT_EQ(nodes.unit("force_x"), "N/m");
    const Table fields = read_csv(scratch / "csv" / "fields_000001.csv");
    EXPECT_EQ(fields.rows(), static_cast<std::size_t>(frames.header().nx) * frames.header().ny);
    EXPECT_GT(fs::file_size(scratch / "csv" / "README.txt"), 0u);
}

TEST(Export, directory_without_frames_is_told) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--stage started");
    try {
        export_vtk(scratch / "run", scratch / "vtk");
        FAIL();
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("frames.h5: does not exist"), std::string::npos);
    }
    EXPECT_THROW(export_csv(scratch / "absent", scratch / "csv"), IoError);
}

TEST(Csv, last_line_that_is_still_being_written_is_left_out) {
    ScratchFolder scratch;
    std::ofstream(scratch / "t.csv") << "time [s],x,y\n0,1,2\n1,2";
    EXPECT_EQ(read_csv(scratch / "t.csv").rows(), 1u);
}

}  // namespace
}  // namespace tt
