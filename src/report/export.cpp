#include "report/export.hpp"

#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/vtk.hpp"
#include "report/frames.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
constexpr double um = 1e6, ms = 1e3;  ///< per metre, per second

FrameFile open_frames(const fs::path& directory) {
    if (!fs::is_directory(directory)) throw IoError(directory.string() + ": no such results directory");
    const fs::path path = directory / "frames.h5";
    if (!fs::exists(path)) throw IoError(path.string() + ": does not exist; nothing to export (was the run started, and are frames on?)");
    return FrameFile(path);
}

void require_frames(const FrameFile& frames, const fs::path& directory) {
    if (frames.count() == 0) throw IoError((directory / "frames.h5").string() + ": holds no complete frame yet");
}

void make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw IoError(folder.string() + ": cannot be made: " + failure.message());
}

/// Three components, as VTK wants vectors.
std::vector<double> with_zero(const std::vector<Vec2>& vectors, double factor) {
    std::vector<double> flat;
    for (const Vec2 v : vectors) flat.insert(flat.end(), {factor * v.x, factor * v.y, 0.0});
    return flat;
}

void write_flow(const fs::path& path, const FrameGrid& grid, const Frame& frame) {
    std::vector<VtkArray> arrays;
    std::vector<float> velocity;
    for (std::size_t k = 0; k < frame.velocity_x.size(); ++k)
        velocity.insert(velocity.end(), {1e3f * frame.velocity_x[k], 1e3f * frame.velocity_y[k], 0.0f});
    if (!velocity.empty()) arrays.push_back(vtk_array("velocity [mm/s]", 3, velocity));
    if (!frame.density.empty()) arrays.push_back(vtk_array("density", 1, frame.density));
    if (!frame.pressure.empty()) arrays.push_back(vtk_array("pressure [Pa]", 1, frame.pressure));
    if (!frame.fraction.empty()) arrays.push_back(vtk_array("cytoplasm fraction", 1, frame.fraction));
    const double h = grid.dx * um;
    write_vti(path, grid.nx, grid.ny, {0.5 * h, 0.5 * h}, h, arrays);
}

/// Length of the segment that starts at each node [m].
std::vector<double> segment_lengths(const FrameGrid& grid, const std::vector<Vec2>& nodes) {
    std::vector<double> lengths;
    for (std::size_t c = 0; c + 1 < grid.first.size(); ++c)
        for (int k = grid.first[c]; k < grid.first[c + 1]; ++k) {
            const int next = k + 1 < grid.first[c + 1] ? k + 1 : grid.first[c];
            lengths.push_back(norm(nodes[static_cast<std::size_t>(next)] - nodes[static_cast<std::size_t>(k)]));
        }
    return lengths;
}

/// Lengths that stretch is measured against, and the name that says which.
struct RestLengths {
    std::vector<double> lengths;
    std::string name;
};

RestLengths rest_lengths(const FrameFile& frames) {
    if (frames.rest_length().size() == static_cast<std::size_t>(frames.grid().node_count()))
        return {frames.rest_length(), "stretch"};
    return {segment_lengths(frames.grid(), frames.read_nodes(0)), "stretch since the first frame"};
}

void write_cells(const fs::path& path, const FrameGrid& grid, Frame frame, const RestLengths& rest) {
    std::vector<std::int32_t> cell, cell_of_node;
    std::vector<double> stretch = segment_lengths(grid, frame.nodes);
    for (std::size_t k = 0; k < stretch.size(); ++k) stretch[k] /= rest.lengths[k];
    for (int c = 0; c < grid.cell_count(); ++c) {
        const auto index = static_cast<std::size_t>(c);
        cell.push_back(c);
        cell_of_node.insert(cell_of_node.end(), static_cast<std::size_t>(grid.first[index + 1] - grid.first[index]), c);
        wrap_cell(frame.nodes, grid.first[index], grid.first[index + 1], grid.length);
    }
    for (Vec2& node : frame.nodes) node *= um;
    std::vector<VtkArray> arrays{vtk_array(rest.name, 1, stretch), vtk_array("cell", 1, cell_of_node)};
    if (!frame.node_force.empty()) arrays.push_back(vtk_array("node force [N/m]", 3, with_zero(frame.node_force, 1.0)));
    if (!frame.node_velocity.empty()) arrays.push_back(vtk_array("velocity [mm/s]", 3, with_zero(frame.node_velocity, 1e3)));
    write_vtp(path, frame.nodes, grid.first, arrays, {vtk_array("cell", 1, cell)});
}

std::string nodes_table(const FrameGrid& grid, const Frame& frame) {
    const bool dynamic = !frame.node_force.empty() && !frame.node_velocity.empty();
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "cell,node,x [m],y [m]{}\n", dynamic ? ",force_x [N/m],force_y [N/m],velocity_x [m/s],velocity_y [m/s]" : "");
    for (int c = 0; c < grid.cell_count(); ++c) {
        const auto begin = static_cast<std::size_t>(grid.first[static_cast<std::size_t>(c)]);
        const auto end = static_cast<std::size_t>(grid.first[static_cast<std::size_t>(c) + 1]);
        for (std::size_t k = begin; k < end; ++k) {
            fmt::format_to(out, "{},{},{:.10g},{:.10g}", c, k - begin, frame.nodes[k].x, frame.nodes[k].y);
            if (dynamic)
                fmt::format_to(out, ",{:.9g},{:.9g},{:.9g},{:.9g}", frame.node_force[k].x, frame.node_force[k].y,
                               frame.node_velocity[k].x, frame.node_velocity[k].y);
            text.push_back('\n');
        }
    }
    return fmt::to_string(text);
}

std::string fields_table(const FrameGrid& grid, const Frame& frame) {
    struct Column {
        const char* title;
        const std::vector<float>& values;
    };
    std::vector<Column> columns;
    for (const Column& column : {Column{"velocity_x [m/s]", frame.velocity_x}, Column{"velocity_y [m/s]", frame.velocity_y},
                                 Column{"density", frame.density}, Column{"pressure [Pa]", frame.pressure},
                                 Column{"fraction", frame.fraction}})
        if (!column.values.empty()) columns.push_back(column);
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "x [m],y [m]");
    for (const Column& column : columns) fmt::format_to(out, ",{}", column.title);
    text.push_back('\n');
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            fmt::format_to(out, "{:.7g},{:.7g}", (i + 0.5) * grid.dx, (j + 0.5) * grid.dx);
            for (const Column& column : columns)
                fmt::format_to(out, ",{:.7g}", column.values[static_cast<std::size_t>(j) * grid.nx + i]);
            text.push_back('\n');
        }
    return fmt::to_string(text);
}

constexpr const char* csv_readme = R"(Frames of a tanktread run as plain tables, SI units.

frames.csv         frame   number that the other files carry
                   time    [s]
                   step    time step
nodes_NNNNNN.csv   membrane nodes, counter-clockwise around each cell
                   cell, node              numbers from 0
                   x, y                    position [m]; x is not wrapped: it counts on when a cell leaves through an end
                   force_x, force_y        force of the node on the fluid, per unit depth [N/m]
                   velocity_x, velocity_y  [m/s]
fields_NNNNNN.csv  sites of the lattice, row after row from the bottom wall
                   x, y                    position [m]; walls are half a spacing below the first row and above the last
                   velocity_x, velocity_y  [m/s]
                   density or pressure     as the run wrote it
                   fraction                share of cytoplasm at the site, 0 to 1
)";

}  // namespace

void export_vtk(const fs::path& directory, const fs::path& out) {
    const FrameFile frames = open_frames(directory);
    require_frames(frames, directory);
    make_folder(out / "flow");
    make_folder(out / "cells");
    const RestLengths rest = rest_lengths(frames);
    std::vector<PvdEntry> flow, cells;
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.read(k);
        flow.push_back({frame.time * ms, fmt::format("flow/flow_{:06d}.vti", k)});
        cells.push_back({frame.time * ms, fmt::format("cells/cells_{:06d}.vtp", k)});
        write_flow(out / flow.back().file, frames.grid(), frame);
        write_cells(out / cells.back().file, frames.grid(), frame, rest);
    }
    write_pvd(out / "flow.pvd", flow);
    write_pvd(out / "cells.pvd", cells);
}

void export_csv(const fs::path& directory, const fs::path& out) {
    const FrameFile frames = open_frames(directory);
    require_frames(frames, directory);
    make_folder(out);
    std::string index = "frame,time [s],step\n";
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.read(k);
        index += fmt::format("{},{:.10g},{}\n", k, frame.time, frame.step);
        write_text(out / fmt::format("nodes_{:06d}.csv", k), nodes_table(frames.grid(), frame));
        write_text(out / fmt::format("fields_{:06d}.csv", k), fields_table(frames.grid(), frame));
    }
    write_text(out / "frames.csv", index);
    write_text(out / "README.txt", csv_readme);
}

}  // namespace tt
