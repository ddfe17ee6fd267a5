#include "report/export.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numbers>
#include <regex>
#include <span>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/csv.hpp"
#include "report/frames.hpp"
#include "report/triangulate.hpp"
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

/// The values of every block of that name.
template <class T>
std::vector<std::vector<T>> all_values(const std::vector<Block>& blocks, const std::string& name) {
    std::vector<std::vector<T>> all;
    for (const Block& block : blocks) {
        if (block.name != name) continue;
        all.emplace_back(block.bytes.size() / sizeof(T));
        std::memcpy(all.back().data(), block.bytes.data(), block.bytes.size());
    }
    return all;
}

template <class T>
std::vector<T> values(const std::vector<Block>& blocks, const std::string& name) {
    auto all = all_values<T>(blocks, name);
    if (!all.empty()) return all.front();
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
    ASSERT_GE(points.size(), 3 * frame.nodes.size() / 2);
    EXPECT_DOUBLE_EQ(points[1], 1e6 * frame.nodes[1]);
    EXPECT_EQ(values<double>(cells, "node force [N/m]").size(), points.size());

    const std::string index = text_of(scratch / "vtk" / "cells.pvd");
    EXPECT_NE(index.find("timestep=\"80\" part=\"0\" file=\"cells/cells_000002.vtp\""),
              std::string::npos);
}

double area_of(std::span<const Vec2> p, const std::vector<std::array<int, 3>>& triangles) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double one = 0.5 * cross(p[b] - p[a], p[c] - p[a]);
        EXPECT_GE(one, 0.0);
        area += one;
    }
    return area;
}

double area_of(std::span<const Vec2> p) {
    double area = 0.0;
    for (std::size_t k = 0; k < p.size(); ++k) area += 0.5 * cross(p[k], p[(k + 1) % p.size()]);
    return area;
}

TEST(Triangulate, fills_hollow_shapes_and_nothing_else) {
    for (const double hollow : {0.0, 0.4, 0.8, 0.95}) {
        std::vector<Vec2> points;  // a C, ever more closed, and a peanut
        for (int k = 0; k < 160; ++k) {
            const double t = 2.0 * std::numbers::pi * k / 160;
            const double r = 1.0 - hollow * std::exp(-8.0 * (t - 1.0) * (t - 1.0)) -
                             0.5 * hollow * std::exp(-9.0 * (t - 4.0) * (t - 4.0));
            points.push_back({r * std::cos(t), r * std::sin(t)});
        }
        const auto triangles = triangulate(points);
        EXPECT_EQ(triangles.size(), points.size() - 2);
        EXPECT_NEAR(area_of(points, triangles), area_of(points), 1e-12);
    }
    const std::vector<Vec2> eight{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    EXPECT_EQ(triangulate(eight).size(), 2u);
    EXPECT_TRUE(triangulate({}).empty());
}

/// The sum of the triangles of one cell's own, not of its images.
TEST(ExportVtk, cells_are_filled_stretched_against_rest_and_measured) {
    ScratchFolder scratch;
    invent_results(scratch / "run", "--frames 3");
    export_vtk(scratch / "run", scratch / "vtk");
    const FramesReader frames((scratch / "run") / "frames.h5");
    const FramesHeader& grid = frames.header();
    const std::vector<Vec2> nodes = wrapped_nodes(grid, frames.frame(2));
    const fs::path file = scratch / "vtk" / "cells" / "cells_000002.vtp";
    const auto blocks = blocks_of(file);
    const auto points = values<double>(blocks, "Points");
    const auto corners = all_values<std::int64_t>(blocks, "connectivity").at(1);
    const auto lines = all_values<std::int64_t>(blocks, "offsets").at(0).size();
    const auto cell = all_values<std::int32_t>(blocks, "cell").at(1);
    const auto image = values<std::int32_t>(blocks, "image");
    const auto stated = values<double>(blocks, "area [um^2]");
    const auto extension = values<double>(blocks, "lambda_C");
    const auto stretch = values<double>(blocks, "stretch");
    ASSERT_EQ(cell.size(), lines + corners.size() / 3);
    ASSERT_EQ(stated.size(), cell.size());
    std::vector<double> area(4, 0.0);
    double left = 1e9, right = -1e9;
    for (std::size_t e = lines; e < cell.size(); ++e) {
        Vec2 p[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = 3 * static_cast<std::size_t>(corners[3 * (e - lines) + k]);
            p[k] = {points[at], points[at + 1]};
            left = std::min(left, p[k].x);
            right = std::max(right, p[k].x);
        }
        if (image[e] == 0)
            area[static_cast<std::size_t>(cell[e])] += 0.5 * cross(p[1] - p[0], p[2] - p[0]);
    }
    for (std::size_t c = 0; c < 4; ++c) {
        const auto begin = static_cast<std::size_t>(grid.first[c]);
        const std::size_t count = static_cast<std::size_t>(grid.first[c + 1]) - begin;
        const double truth = 1e12 * area_of(std::span(nodes).subspan(begin, count));
        EXPECT_NEAR(area[c], truth, 1e-9 * truth);
        const auto line =
            static_cast<std::size_t>(std::find(cell.begin(), cell.end(), c) - cell.begin());
        EXPECT_NEAR(stated[line], truth, 1e-9 * truth);
    }
    // An outline of equal segments: λ_C is their mean stretch against rest.
    double sum = 0.0;
    for (std::size_t k = 0; k < 40; ++k) sum += stretch[k];
    EXPECT_NEAR(extension[0], sum / 40, 1e-9);
    EXPECT_GT(extension[0], 1.01);
    const bool crosses = std::any_of(nodes.begin(), nodes.end(),
                                     [&](Vec2 p) { return p.x < 0.0 || p.x > grid.length; });
    const bool images = std::count(image.begin(), image.end(), 1) > 0;
    EXPECT_EQ(crosses, images);
    EXPECT_NE(text_of(scratch / "vtk" / "README.txt").find("lengths um"), std::string::npos);
}

TEST(ExportVtk, a_cell_across_an_end_has_an_image_at_the_other) {
    FramesHeader grid;
    grid.length = grid.width = 10.0;
    grid.first = {0, 3, 6, 9};
    const std::vector<Vec2> nodes{{-1, 0}, {2, 0}, {1, 1},  {4, 0}, {6, 0},
                                  {5, 1},  {8, 0}, {12, 0}, {9, 1}};
    EXPECT_EQ(image_shifts(grid, nodes, 0), (std::vector<Vec2>{{}, {10.0, 0.0}}));
    EXPECT_EQ(image_shifts(grid, nodes, 1), (std::vector<Vec2>{{}}));
    EXPECT_EQ(image_shifts(grid, nodes, 2), (std::vector<Vec2>{{}, {-10.0, 0.0}}));
    // In a corner of a box that is periodic both ways: three.
    grid.first = {0, 3};
    EXPECT_EQ(image_shifts(grid, {{-1, -1}, {2, -1}, {1, 1}}, 0).size(), 4u);
}

TEST(Export, what_a_longer_one_left_goes_and_other_files_stay) {
    ScratchFolder scratch;
    invent_results(scratch / "long", "--frames 5");
    invent_results(scratch / "short", "--frames 2");
    for (const char* run : {"long", "short"}) {
        export_vtk(scratch / run, scratch / "out");
        export_csv(scratch / run, scratch / "out");
        std::ofstream(scratch / "out" / "nodes_mine.csv") << "mine\n";
    }
    for (const char* name : {"flow/flow_000004.vti", "cells/cells_000002.vtp", "nodes_000003.csv",
                             "fields_000004.csv"})
        EXPECT_FALSE(fs::exists(scratch / "out" / name)) << name;
    for (const char* name :
         {"flow/flow_000001.vti", "cells/cells_000001.vtp", "nodes_000001.csv", "nodes_mine.csv"})
        EXPECT_TRUE(fs::exists(scratch / "out" / name)) << name;
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

TEST(Csv, a_quote_left_open_is_told_with_its_line) {
    ScratchFolder scratch;
    for (const char* text : {"time [s],x\n0,1\n1,\"2\n2,3\n", "time [s],\"x\n0,1\n"}) {
        std::ofstream(scratch / "t.csv") << text;
        const bool in_heading = std::string(text).find("\"x") != std::string::npos;
        const std::string place = (scratch / "t.csv").string() + (in_heading ? ":1" : ":3");
        try {
            read_csv(scratch / "t.csv");
            FAIL() << text;
        } catch (const IoError& error) {
            EXPECT_EQ(std::string(error.what()),
                      place + ": a quote (\") is left open; close it, or leave it out");
        }
    }
}

TEST(Csv, last_line_that_is_still_being_written_is_left_out) {
    ScratchFolder scratch;
    std::ofstream(scratch / "t.csv") << "time [s],x,y\n0,1,2\n1,2";
    EXPECT_EQ(read_csv(scratch / "t.csv").rows(), 1u);
}

TEST(Export, leaves_folders_of_others_alone_and_renews_its_own) {
    ScratchFolder scratch;
    invent_results(scratch / "run");
    fs::create_directories(scratch / "mine");
    std::ofstream(scratch / "mine" / "nodes_000099.csv") << "mine";
    EXPECT_THROW(export_csv(scratch / "run", scratch / "mine"), IoError);
    EXPECT_THROW(export_vtk(scratch / "run", scratch / "mine"), IoError);
    EXPECT_EQ(text_of(scratch / "mine" / "nodes_000099.csv"), "mine");
    try {
        export_csv(scratch / "run", scratch / "mine" / "nodes_000099.csv");
        FAIL() << "a file was taken for a folder";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("is a file; name a folder"), std::string::npos);
    }
    export_csv(scratch / "run", scratch / "csv");
    std::ofstream(scratch / "csv" / "nodes_000099.csv") << "of a longer run";
    export_csv(scratch / "run", scratch / "csv");
    EXPECT_FALSE(fs::exists(scratch / "csv" / "nodes_000099.csv"));
}

}  // namespace
}  // namespace tt
