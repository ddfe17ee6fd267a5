#include "case/suspend.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/choose.hpp"
#include "case/feeds.hpp"
#include "case/kinds.hpp"
#include "case/layout.hpp"
#include "interaction/contact.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// The outline of a file with this many nodes, about the centroid of its area. A neck that is
/// thinner than the nodes are apart may be cut off.
std::vector<Vec2> resampled(const CellOutline& outline, double nodes) {
    constexpr double most_nodes = 1e5;
    if (nodes > most_nodes)
        throw CaseError({{outline.file, 0, 0,
                          fmt::format("the outline is so long that it takes {:.3g} nodes; at most "
                                      "{:.0f} are possible. Smooth it or write a larger dx",
                                      nodes, most_nodes)}});
    std::vector<Vec2> shape = at_equal_arc_length(outline.points, static_cast<int>(nodes));
    std::vector<double> x, y;
    for (const Vec2 p : shape) {
        x.push_back(p.x);
        y.push_back(p.y);
    }
    const auto refuse = [&](int node, const char* what) {
        throw CaseError({{outline.file, 0, 0,
                          fmt::format("with {} nodes the outline {} near ({:.4g}, {:.4g}) um from "
                                      "its middle, where it is thinner than the grid; write a "
                                      "smaller dx, or draw it thicker there",
                                      nodes, what, 1e6 * x[node], 1e6 * y[node])}});
    };
    const double touching = 0.1 * perimeter_of(shape) / nodes;
    if (const auto crossing = self_crossing({x, y})) refuse(crossing->first, "crosses itself");
    if (const auto near = self_approach({x, y}, touching)) refuse(near->node, "touches itself");
    return placed(shape, 0.0, -centroid_of(shape));
}

/// The stress-free outline about the origin, in sites, with nodes at the spacing the case asks for.
std::vector<Vec2> stress_free_shape(const Case& c, double dx) {
    const double spacing = node_spacing(c) * dx;
    const double radius = c.cells.radius.si;
    const auto nodes = [&](double perimeter) {
        return std::max(8, static_cast<int>(std::ceil(perimeter / spacing - 0.01)));
    };
    std::vector<Vec2> shape;
    if (const CellOutline* outline = c.cells.outline()) {
        shape = resampled(*outline, nodes(perimeter_of(outline->points)));
    } else if (std::holds_alternative<BiconcaveShape>(c.cells.shape)) {
        shape = biconcave(radius, nodes(perimeter_of(biconcave(radius, 1000))));
    } else if (const auto* ellipse_shape = std::get_if<EllipseShape>(&c.cells.shape)) {
        const double aspect = ellipse_shape->aspect_ratio;
        const double major = radius * std::sqrt(aspect), minor = radius / std::sqrt(aspect);
        shape = ellipse(major, minor, nodes(perimeter_of(ellipse(major, minor, 1000))));
    } else {
        shape = circle(radius, nodes(2.0 * std::numbers::pi * radius));
    }
    for (Vec2& p : shape) p *= 1.0 / dx;
    return shape;
}

/// The outlines of all kinds.
std::vector<std::vector<Vec2>> shapes_of(const std::vector<Case>& kinds, double dx) {
    std::vector<std::vector<Vec2>> shapes;
    for (const Case& one : kinds) shapes.push_back(stress_free_shape(one, dx));
    return shapes;
}

/// So many of each, in any order.
Crowd crowd_of(const Case& c, std::vector<std::vector<Vec2>> shapes, double room, int multiple,
               std::uint64_t seed) {
    std::vector<double> areas;
    for (const auto& shape : shapes) areas.push_back(area_of(shape));
    Crowd crowd;
    crowd.shapes = std::move(shapes);
    crowd.shape_of = mixed(cells_of_kinds(c, areas, room, multiple), seed);
    return crowd;
}

/// The positions of each kind.
void place_explicitly(const Case& c, const std::vector<Case>& kinds, const Model& m, Crowd& crowd,
                      std::vector<Placement>& places) {
    const auto place = [&](const std::vector<std::vector<Length>>& positions, std::size_t kind) {
        for (const auto& p : positions) {
            const Vec2 at{m.scales.to_lattice(p[0]), m.scales.to_lattice(p[1])};
            places.push_back({at - m.origin, kinds[kind].cells.angle.si});
            crowd.shape_of.push_back(static_cast<int>(kind));
        }
    };
    if (c.kinds.empty()) return place(std::get<AtPositions>(c.cells.layout).positions, 0);
    for (std::size_t n = 0; n < c.kinds.size(); ++n) place(c.kinds[n].positions, n);
}

/// Who is laid, and where.
struct Start {
    Crowd crowd;
    std::vector<Placement> places;
};
Start start_of(const Case& c, const std::vector<Case>& kinds, const Model& m,
               const LayoutWatch& watch) {
    const double length = m.lattice.nx, width = m.lattice.ny;
    const auto seed = static_cast<std::uint64_t>(c.cells.seed);
    const Walls* const walls = m.boundaries.walls.get();
    const Walls closed = m.exits.empty() ? Walls{} : with_closed_ports(m);
    const Room room{m.lattice, m.exits.empty() ? walls : &closed};
    // What comes in fills the stretch before a port that feeds.
    const double area = m.feeds.empty() ? m.open_area() : room.area();
    std::vector<std::vector<Vec2>> shapes = shapes_of(kinds, m.scales.length);
    Start start;
    if (std::holds_alternative<AtPositions>(c.cells.layout)) {
        start.crowd.shapes = std::move(shapes);
        place_explicitly(c, kinds, m, start.crowd, start.places);
    } else if (const auto* rows = std::get_if<PaperRows>(&c.cells.layout)) {
        start.crowd = crowd_of(c, std::move(shapes), area, 2, seed);
        start.places = two_rows(start.crowd.count(), length, width,
                                m.scales.to_lattice(rows->perturbation), seed);
        for (std::size_t n = 0; n < start.places.size(); ++n)
            start.places[n].angle = kinds[start.crowd.shape_of[n]].cells.angle.si;
    } else if (std::holds_alternative<AtRandom>(c.cells.layout)) {
        start.crowd = crowd_of(c, std::move(shapes), area, 1, seed);
        start.places = random_placements(start.crowd, room, seed, watch);
    } else {
        start.crowd = {shapes.front(), 1};
        start.places = {{{0.5 * length, 0.5 * width}, kinds.front().cells.angle.si}};
    }
    return start;
}

/// Deforms the placed outline to an ellipse-like shape of this axis ratio at constant area, long
/// along the axis that it is turned to.
void stretch(const Placement& place, double ratio, Suspension& cells, int cell) {
    const double along = std::sqrt(ratio);
    const Vec2 axis{std::cos(place.angle), std::sin(place.angle)};
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        const Vec2 from_centre = cells.position(n) - place.centre;
        const double u = along * dot(axis, from_centre), v = cross(axis, from_centre) / along;
        cells.x[n] = place.centre.x + u * axis.x - v * axis.y;
        cells.y[n] = place.centre.y + u * axis.y + v * axis.x;
    }
}

/// Puts the nodes of the cell added last elsewhere; its stress-free shape stays.
void move_last_cell_to(const std::vector<Vec2>& points, Suspension& cells) {
    const int first = cells.first[cells.cell_count() - 1];
    for (std::size_t k = 0; k < points.size(); ++k) {
        cells.x[first + k] = points[k].x;
        cells.y[first + k] = points[k].y;
    }
}

void add_placed(const Crowd& crowd, int cell, const Placement& place, Suspension& cells) {
    const std::vector<Vec2>& shape = crowd.shape(cell);
    add_cell(cells, placed(shape, place.angle, place.centre), crowd.shape_of[cell]);
    if (!place.bend.empty()) move_last_cell_to(placed(shape, place), cells);
}

void refuse_bad_placements(const Case& c, const Model& m, const Suspension& cells) {
    const bool random = std::holds_alternative<AtRandom>(c.cells.layout);
    const char* const cure = random ? "" : ", or write layout = \"random\"";
    const double um = 1e6 * m.scales.length;
    std::vector<Fault> faults;
    const Walls* const walls = m.boundaries.walls.get();
    for (int cell = 0; walls && cell < cells.cell_count(); ++cell) {
        for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
            if (walls->distance_at(cells.position(n)) > 0.0) continue;
            faults.push_back(
                {"", 0, 0,
                 fmt::format("[cells] cell {} reaches into a wall at ({:.4g}, {:.4g}) um; make it "
                             "smaller or move it{}",
                             cell, cells.x[n] * um, cells.y[n] * um, cure)});
            break;
        }
    }
    for (int cell = 0; cell < cells.cell_count(); ++cell)
        for (std::size_t n = 0; n < m.exits.size(); ++n)
            if (way_to(m.exits[n], m, cells, cell) < kernel_reach)
                faults.push_back(
                    {"", 0, 0,
                     fmt::format("[cells] cell {} lies in port '{}'; move it into the channel{}",
                                 cell, m.port_names[n], cure)});
    for (int cell = 0; m.lattice.walls && !walls && cell < cells.cell_count(); ++cell) {
        for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
            if (cells.y[n] > 0.0 && cells.y[n] < m.lattice.ny) continue;
            faults.push_back(
                {"", 0, 0,
                 fmt::format("[cells] cell {} reaches beyond a wall (y = {:.3g} um, width {:.3g} "
                             "um); make it smaller or move it",
                             cell, cells.y[n] * um, m.lattice.ny * um)});
            break;
        }
    }
    if (!faults.empty()) throw CaseError(faults);
}

/// Dense cells are pressed into their places, which bends them.
void refuse_bent_bodies(const Case& c, const std::vector<Case>& kinds, const Crowd& crowd,
                        const std::vector<Placement>& places, const std::string& where) {
    for (int cell = 0; cell < crowd.count(); ++cell) {
        const int kind = crowd.shape_of[cell];
        if (!kinds[kind].membrane.rigid || places[cell].bend.empty()) continue;
        const std::string who = c.kinds.empty()
                                    ? "rigid bodies"
                                    : fmt::format("those of kind '{}'", c.kinds[kind].name);
        throw CaseError({{"", 0, 0,
                          fmt::format("{}: so dense cells have to be pressed together, and {} keep "
                                      "their shape; write a lower hematocrit, or a smaller count",
                                      where, who)}});
    }
}

}  // namespace

void refuse_overlaps(const Model& m, const Suspension& cells) {
    std::vector<Fault> faults;
    std::set<std::pair<int, int>> told;
    for (const Overlap& overlap : find_overlaps(m.lattice, cells)) {
        if (!told.insert(std::minmax(overlap.cell, overlap.other)).second) continue;
        if (overlap.cell == overlap.other) {
            faults.push_back({"", 0, 0,
                              fmt::format("[cells] cell {} is longer than the box, {:.3g} um, and "
                                          "meets its own periodic image; make it smaller or the "
                                          "box longer",
                                          overlap.cell, m.lattice.nx * m.scales.length * 1e6)});
            continue;
        }
        faults.push_back({"", 0, 0,
                          fmt::format("[cells] cells {} and {} overlap at the start; use fewer or "
                                      "smaller cells, or another "
                                      "layout or seed",
                                      overlap.cell, overlap.other)});
    }
    if (!faults.empty()) throw CaseError(faults);
}

Suspension suspended_cells(const Case& c, const Model& m, const LayoutWatch& watch) {
    Suspension cells;
    if (c.numerics.fluid_only) return cells;
    const std::vector<Case> kinds = cases_by_kind(c);
    const Start start = start_of(c, kinds, m, watch);
    refuse_bent_bodies(c, kinds, start.crowd, start.places, "[cells]");
    for (int cell = 0; cell < start.crowd.count(); ++cell) {
        const Placement& place = start.places[cell];
        add_placed(start.crowd, cell, place, cells);
        if (const auto ratio = kinds[start.crowd.shape_of[cell]].cells.initial_stretch)
            stretch(place, *ratio, cells, cell);
    }
    refuse_bad_placements(c, m, cells);
    refuse_overlaps(m, cells);
    return cells;
}

Suspension cells_of_feed(const Case& c, const Model& network, const Feed& feed,
                         const LayoutWatch& watch) {
    Suspension cells;
    const Model& channel = *feed.channel;
    const FeedCase& asked = c.ports[static_cast<std::size_t>(feed.port)].feed;
    Case in_channel = c;
    in_channel.cells.count.reset();
    in_channel.cells.hematocrit = asked.hematocrit;
    const auto seed = static_cast<std::uint64_t>(asked.seed.value_or(1));
    const Crowd crowd = crowd_of(in_channel, shapes_of(cases_by_kind(c), channel.scales.length),
                                 channel.open_area(), 1, seed);
    const std::string where =
        fmt::format("[port.{}.feed]", network.port_names[static_cast<std::size_t>(feed.port)]);
    const std::vector<Placement> places = random_placements(
        crowd, {channel.lattice, channel.boundaries.walls.get()}, seed, watch, where);
    refuse_bent_bodies(c, cases_by_kind(c), crowd, places, where);
    for (int cell = 0; cell < crowd.count(); ++cell) add_placed(crowd, cell, places[cell], cells);
    return cells;
}

}  // namespace tt
