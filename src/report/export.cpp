#include "report/export.hpp"

#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tell.hpp"
#include "io/file.hpp"
#include "io/vtk.hpp"
#include "report/frames.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
constexpr double um = 1e6, ms = 1e3;  ///< per metre, per second

/// The frames of a results directory; tells what is damaged. Throws IoError if there is none to
/// export.
std::unique_ptr<const FramesReader> open_frames(const fs::path& directory) {
    if (!fs::is_directory(directory))
        throw IoError(directory.string() + ": no such results directory");
    const fs::path path = directory / "frames.h5";
    if (!fs::exists(path))
        throw IoError(path.string() +
                      ": does not exist; nothing to export (did the run write frames?)");
    auto frames = std::make_unique<const FramesReader>(path);
    for (const std::string& fault : frames->faults()) tell_user("tanktread: {}\n", fault);
    if (frames->count() == 0) throw IoError(path.string() + ": holds no frame that can be read");
    return frames;
}

/// Three components, as VTK wants vectors, of x, y pairs.
template <class T>
std::vector<T> with_zero(const std::vector<T>& pairs, T factor) {
    std::vector<T> flat;
    for (std::size_t k = 0; k + 1 < pairs.size(); k += 2) {
        flat.insert(flat.end(), {factor * pairs[k], factor * pairs[k + 1], T{0}});
    }
    return flat;
}

void write_flow(const fs::path& path, const FramesHeader& header, const Frame& frame) {
    const double h = header.dx * um;
    write_vti(path, header.nx, header.ny, {0.5 * h, 0.5 * h}, h,
              {vtk_array("velocity [mm/s]", 3, with_zero(frame.velocity, 1e3f)),
               vtk_array("pressure [Pa]", 1, frame.pressure),
               vtk_array("cytoplasm fraction", 1, frame.cytoplasm)});
}

void write_cells(const fs::path& path, const FramesHeader& header, const Frame& frame,
                 const std::vector<double>& first_lengths) {
    std::vector<std::int32_t> cell, cell_of_node;
    for (int c = 0; c < cell_count(header); ++c) {
        const auto index = static_cast<std::size_t>(c);
        const auto count = static_cast<std::size_t>(header.first[index + 1] - header.first[index]);
        cell.push_back(c);
        cell_of_node.insert(cell_of_node.end(), count, c);
    }
    std::vector<double> stretch = segment_lengths(header, frame);
    for (std::size_t k = 0; k < stretch.size(); ++k) stretch[k] /= first_lengths[k];
    std::vector<Vec2> nodes = wrapped_nodes(header, frame);
    for (Vec2& node : nodes) node *= um;
    write_vtp(
        path, nodes, header.first,
        {vtk_array("stretch since the first frame", 1, stretch), vtk_array("cell", 1, cell_of_node),
         vtk_array("node force [N/m]", 3, with_zero(frame.node_force, 1.0)),
         vtk_array("velocity [mm/s]", 3, with_zero(frame.node_velocity, 1e3))},
        {vtk_array("cell", 1, cell)});
}

std::string nodes_table(const FramesHeader& header, const Frame& frame) {
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "cell,node,x [m],y [m],force_x [N/m],force_y [N/m],"
                   "velocity_x [m/s],velocity_y [m/s]\n");
    for (int c = 0; c < cell_count(header); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c)]);
        const auto end = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c) + 1]);
        for (std::size_t k = begin; k < end; ++k) {
            fmt::format_to(out, "{},{},{:.10g},{:.10g},{:.9g},{:.9g},{:.9g},{:.9g}\n", c, k - begin,
                           frame.nodes[2 * k], frame.nodes[2 * k + 1], frame.node_force[2 * k],
                           frame.node_force[2 * k + 1], frame.node_velocity[2 * k],
                           frame.node_velocity[2 * k + 1]);
        }
    }
    return fmt::to_string(text);
}

std::string fields_table(const FramesHeader& header, const Frame& frame) {
    fmt::memory_buffer text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "x [m],y [m],velocity_x [m/s],velocity_y [m/s],pressure [Pa],cytoplasm\n");
    for (int j = 0; j < header.ny; ++j)
        for (int i = 0; i < header.nx; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * header.nx + i;
            fmt::format_to(out, "{:.7g},{:.7g},{:.7g},{:.7g},{:.7g},{:.7g}\n",
                           (i + 0.5) * header.dx, (j + 0.5) * header.dx, frame.velocity[2 * site],
                           frame.velocity[2 * site + 1], frame.pressure[site],
                           frame.cytoplasm[site]);
        }
    return fmt::to_string(text);
}

constexpr const char* csv_readme = R"(Frames of a tanktread run as plain tables, SI units.

frames.csv         frame   number that the other files carry
                   time    [s]
                   step    time step
nodes_NNNNNN.csv   membrane nodes, counter-clockwise around each cell
                   cell, node              numbers from 0
                   x, y                    position [m]; x counts on when a cell leaves through an end
                   force_x, force_y        force of the node on the fluid, per unit depth [N/m]
                   velocity_x, velocity_y  [m/s]
fields_NNNNNN.csv  sites of the lattice, row after row from the bottom wall
                   x, y                    position [m]; walls stand half a spacing beyond the end rows
                   velocity_x, velocity_y  [m/s]
                   pressure                above its value at rest [Pa]
                   cytoplasm               share of cytoplasm at the site, 0 to 1
)";

}  // namespace

void export_vtk(const fs::path& directory, const fs::path& out) {
    const auto opened = open_frames(directory);
    const FramesReader& frames = *opened;
    make_directory(out / "flow");
    make_directory(out / "cells");
    const std::vector<double> first_lengths = segment_lengths(frames.header(), frames.frame(0));
    std::vector<PvdEntry> flow, cells;
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.frame(k);
        flow.push_back({frame.time * ms, fmt::format("flow/flow_{:06d}.vti", frames.number(k))});
        cells.push_back({frame.time * ms, fmt::format("cells/cells_{:06d}.vtp", frames.number(k))});
        write_flow(out / flow.back().file, frames.header(), frame);
        write_cells(out / cells.back().file, frames.header(), frame, first_lengths);
    }
    write_pvd(out / "flow.pvd", flow);
    write_pvd(out / "cells.pvd", cells);
}

void export_csv(const fs::path& directory, const fs::path& out) {
    const auto opened = open_frames(directory);
    const FramesReader& frames = *opened;
    make_directory(out);
    std::string index = "frame,time [s],step\n";
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.frame(k);
        const std::int64_t number = frames.number(k);
        index += fmt::format("{},{:.10g},{}\n", number, frame.time, frame.step);
        write_text(out / fmt::format("nodes_{:06d}.csv", number),
                   nodes_table(frames.header(), frame));
        write_text(out / fmt::format("fields_{:06d}.csv", number),
                   fields_table(frames.header(), frame));
    }
    write_text(out / "frames.csv", index);
    write_text(out / "README.txt", csv_readme);
}

}  // namespace tt
