#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/tell.hpp"
#include "base/undefined.hpp"
#include "io/file.hpp"
#include "io/vtk.hpp"
#include "membrane/outline.hpp"
#include "report/export.hpp"
#include "report/frames.hpp"
#include "report/gnuplot.hpp"
#include "report/triangulate.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;
constexpr double um = 1e6, ms = 1e3;  ///< per metre, per second

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

/// A number per cell, as ParaView shows it.
struct CellColumn {
    std::string name;
    std::vector<double> values;
};

/// The measures of cells.csv that the outline alone gives. `nodes` in µm.
std::vector<CellColumn> shape_columns(const FramesHeader& header, std::span<const Vec2> nodes) {
    std::vector<CellColumn> columns{
        {"area [um^2]", {}},    {"perimeter [um]", {}}, {"lambda_C", {}},         {"strain", {}},
        {"taylor_inertia", {}}, {"taylor_extent", {}},  {"inclination [deg]", {}}};
    for (int c = 0; c < cell_count(header); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c)]);
        const auto end = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c) + 1]);
        std::vector<double> x, y;
        double rest = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            x.push_back(nodes[k].x);
            y.push_back(nodes[k].y);
            rest += header.rest_length.empty() ? 0.0 : header.rest_length[k] * um;
        }
        const Outline outline{x, y};
        const AreaMoments moments = area_moments(outline);
        const EquivalentEllipse ellipse = equivalent_ellipse(moments);
        const RadiusRange radii = radius_range(outline, moments.centroid);
        const double length = perimeter(outline);
        const double extension = rest > 0.0 ? length / rest : undefined;
        const double values[] = {moments.area,
                                 length,
                                 extension,
                                 extension - 1.0,
                                 taylor_deformation(ellipse.major, ellipse.minor),
                                 taylor_deformation(radii.largest, radii.smallest),
                                 ellipse.inclination * 180.0 / std::numbers::pi};
        for (std::size_t k = 0; k < columns.size(); ++k) columns[k].values.push_back(values[k]);
    }
    return columns;
}

/// Outlines as lines and their insides as triangles: viewers fill the hollow of a concave polygon.
struct CellMesh {
    std::vector<std::int64_t> node;  ///< of the frame, per point: images repeat them
    std::vector<Vec2> points;        ///< [µm]
    VtkElements lines, triangles;
    std::vector<std::int32_t> cell_of_line, cell_of_triangle;
    std::vector<std::int32_t> image_of_line, image_of_triangle;  ///< 1: of a cell across an end

    void add(int cell, int image, std::int64_t begin, std::span<const Vec2> nodes, Vec2 shift,
             std::span<const std::array<int, 3>> inside);
};

void CellMesh::add(int cell, int image, std::int64_t begin, std::span<const Vec2> nodes, Vec2 shift,
                   std::span<const std::array<int, 3>> inside) {
    const auto first = static_cast<std::int64_t>(points.size());
    std::vector<std::int64_t> ring;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        node.push_back(begin + static_cast<std::int64_t>(k));
        ring.push_back(first + static_cast<std::int64_t>(k));
        points.push_back(nodes[k] + shift);
    }
    ring.push_back(first);
    lines.add(ring);
    cell_of_line.push_back(cell);
    image_of_line.push_back(image);
    for (const auto& [a, b, c] : inside) {
        const std::int64_t corners[] = {first + a, first + b, first + c};
        triangles.add(corners);
    }
    cell_of_triangle.insert(cell_of_triangle.end(), inside.size(), cell);
    image_of_triangle.insert(image_of_triangle.end(), inside.size(), image);
}

CellMesh cell_mesh(const FramesHeader& header, const std::vector<Vec2>& nodes) {
    CellMesh mesh;
    std::vector<Vec2> scaled = nodes;
    for (Vec2& p : scaled) p *= um;
    for (int c = 0; c < cell_count(header); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c)]);
        const auto end = static_cast<std::size_t>(header.first[static_cast<std::size_t>(c) + 1]);
        const auto outline = std::span(scaled).subspan(begin, end - begin);
        const std::vector<Vec2> shifts = image_shifts(header, nodes, c);
        if (shifts.empty()) continue;
        const auto inside = triangulate(outline);
        int image = 0;
        for (const Vec2 shift : shifts) {
            mesh.add(c, image, static_cast<std::int64_t>(begin), outline, um * shift, inside);
            image = 1;
        }
    }
    return mesh;
}

/// Values by index, for the points or elements that stand for each.
template <class T, class Index>
std::vector<T> picked(const std::vector<T>& values, const std::vector<Index>& index) {
    std::vector<T> result;
    for (const Index k : index) result.push_back(values[static_cast<std::size_t>(k)]);
    return result;
}

template <class T>
std::vector<T> joined(std::vector<T> a, const std::vector<T>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The pairs of the nodes that the points stand for, with a third component of zero.
std::vector<double> of_points(const std::vector<double>& pairs, const CellMesh& mesh,
                              double factor) {
    std::vector<double> flat;
    for (const std::int64_t node : mesh.node) {
        const auto k = 2 * static_cast<std::size_t>(node);
        flat.insert(flat.end(), {factor * pairs[k], factor * pairs[k + 1], 0.0});
    }
    return flat;
}

std::vector<VtkArray> node_arrays(const FramesHeader& header, const Frame& frame,
                                  const CellMesh& mesh) {
    std::vector<std::int32_t> cell;
    for (int c = 0; c < cell_count(header); ++c) {
        const auto index = static_cast<std::size_t>(c);
        const int count = header.first[index + 1] - header.first[index];
        cell.insert(cell.end(), static_cast<std::size_t>(count), c);
    }
    std::vector<VtkArray> arrays{
        vtk_array("cell", 1, picked(cell, mesh.node)),
        vtk_array("node force [N/m]", 3, of_points(frame.node_force, mesh, 1.0)),
        vtk_array("velocity [mm/s]", 3, of_points(frame.node_velocity, mesh, 1e3))};
    if (!header.rest_length.empty()) {
        std::vector<double> stretch = segment_lengths(header, frame);
        for (std::size_t k = 0; k < stretch.size(); ++k) stretch[k] /= header.rest_length[k];
        arrays.push_back(vtk_array("stretch", 1, picked(stretch, mesh.node)));
    }
    return arrays;
}

void write_cells(const fs::path& path, const FramesHeader& header, const Frame& frame) {
    const std::vector<Vec2> nodes = wrapped_nodes(header, frame);
    const CellMesh mesh = cell_mesh(header, nodes);
    const std::vector<std::int32_t> cell = joined(mesh.cell_of_line, mesh.cell_of_triangle);
    std::vector<VtkArray> elements{
        vtk_array("cell", 1, cell),
        vtk_array("image", 1, joined(mesh.image_of_line, mesh.image_of_triangle))};
    std::vector<Vec2> scaled = nodes;
    for (Vec2& p : scaled) p *= um;
    if (!header.kind.empty()) elements.push_back(vtk_array("kind", 1, picked(header.kind, cell)));
    for (const CellColumn& column : shape_columns(header, scaled))
        elements.push_back(vtk_array(column.name, 1, picked(column.values, cell)));
    write_vtp(path, mesh.points, mesh.lines, mesh.triangles, node_arrays(header, frame, mesh),
              elements);
}

constexpr const char* vtk_readme =
    R"(Frames of a tanktread run for ParaView and other programs that read VTK files.

Units: lengths um, times ms, velocities mm/s, pressures Pa, forces N/m (per unit depth).
The tables (csv) and frames.h5 are in SI: m, s, m/s.

flow.pvd   one image a frame that holds the flow (flow/flow_NNNNNN.vti; output.fields); points
           are the sites of the lattice
           velocity [mm/s], pressure [Pa] (above its value at rest), cytoplasm fraction
cells.pvd  one set of cells a frame (cells/cells_NNNNNN.vtp): each outline is a line,
           and its inside is filled with triangles, of concave cells too
           A cell stands where its mean lies in the box; one that crosses an end of the
           box has an image, a whole length of the box away, so that the box is filled.
   of each point:
           cell                number from 0
           stretch             length of the segment to the next node / its rest length
           node force [N/m]    of the node on the fluid, per unit depth
           velocity [mm/s]
   of each line and triangle, the same all over a cell:
           cell, image         image is 1 on images: leave them out before you add up
           kind                number of its kind, in the order of the case, from 0
           area [um^2], perimeter [um]      of the whole cell
           lambda_C            perimeter / perimeter at rest
           strain              lambda_C - 1
           taylor_inertia      (L - B)/(L + B) of the ellipse of equal inertia
           taylor_extent       the same of the largest and smallest radius
           inclination [deg]   of the long axis to the flow
)";

}  // namespace

void export_vtk(const fs::path& directory, const fs::path& out) {
    const auto opened = open_frames(directory);
    const FramesReader& frames = *opened;
    constexpr NumberedFiles earlier[] = {{"flow", "flow_", ".vti"}, {"cells", "cells_", ".vtp"}};
    begin_export(out, vtk_readme, earlier);
    make_directory(out / "cells");
    std::vector<PvdEntry> flow, cells;
    for (int k = 0; k < frames.count(); ++k) {
        const Frame frame = frames.frame(k);
        const std::int64_t number = frames.number(k);
        cells.push_back({frame.time * ms, fmt::format("cells/cells_{:06d}.vtp", number)});
        write_cells(out / cells.back().file, frames.header(), frame);
        if (frame.velocity.empty()) continue;
        if (flow.empty()) make_directory(out / "flow");
        flow.push_back({frame.time * ms, fmt::format("flow/flow_{:06d}.vti", number)});
        write_flow(out / flow.back().file, frames.header(), frame);
    }
    fs::remove(out / "flow.pvd");  // of an earlier export
    if (flow.empty())
        tell_user(
            "no frame holds the flow, so there is no flow.pvd; [output] fields = \"never\" "
            "leaves it out of frames\n");
    else
        write_pvd(out / "flow.pvd", flow);
    write_pvd(out / "cells.pvd", cells);
}

}  // namespace tt
