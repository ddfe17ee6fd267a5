#include "case/initial_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/choose.hpp"
#include "case/feeds.hpp"
#include "case/layout.hpp"
#include "case/random_layout.hpp"
#include "coupling/stencil.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "membrane/outline_checks.hpp"
#include "membrane/shapes.hpp"
#include "simulation/derive.hpp"

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

std::vector<Placement> placements(const Case& c, const Model& m, const std::vector<Vec2>& shape,
                                  const LayoutWatch& watch) {
    const double length = m.lattice.nx, width = m.lattice.ny;
    const auto seed = static_cast<std::uint64_t>(c.cells.seed);
    const Walls* const walls = m.boundaries.walls.get();
    const Walls closed = m.exits.empty() ? Walls{} : with_closed_ports(m);
    const Room room{m.lattice, m.exits.empty() ? walls : &closed};
    const auto number = [&](int multiple) {  // as near to the hematocrit as there are whole cells
        if (!c.cells.hematocrit) return static_cast<int>(c.cells.count.value_or(1));
        // What comes in fills the stretch before a port that feeds.
        const double area = m.feeds.empty() ? m.open_area() : room.area();
        const double cells = *c.cells.hematocrit * area / area_of(shape);
        return multiple * std::max(1, static_cast<int>(std::lround(cells / multiple)));
    };
    if (const auto* rows = std::get_if<PaperRows>(&c.cells.layout)) {
        std::vector<Placement> cells =
            two_rows(number(2), length, width, m.scales.to_lattice(rows->perturbation), seed);
        for (Placement& cell : cells) cell.angle = c.cells.angle.si;
        return cells;
    }
    if (std::holds_alternative<AtRandom>(c.cells.layout))
        return random_placements(shape, number(1), room, seed, watch);
    if (const auto* layout = std::get_if<AtPositions>(&c.cells.layout)) {
        std::vector<Placement> cells;
        for (const auto& p : layout->positions) {
            const Vec2 place{m.scales.to_lattice(p[0]), m.scales.to_lattice(p[1])};
            cells.push_back({place - m.origin, c.cells.angle.si});
        }
        return cells;
    }
    return {{{0.5 * length, 0.5 * width}, c.cells.angle.si}};
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

void add_placed(const std::vector<Vec2>& shape, const Placement& place, Suspension& cells) {
    add_cell(cells, placed(shape, place.angle, place.centre));
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
    const std::vector<Vec2> shape = stress_free_shape(c, m.scales.length);
    for (const Placement& place : placements(c, m, shape, watch)) {
        add_placed(shape, place, cells);
        if (c.cells.initial_stretch)
            stretch(place, *c.cells.initial_stretch, cells, cells.cell_count() - 1);
    }
    refuse_bad_placements(c, m, cells);
    refuse_overlaps(m, cells);
    return cells;
}

/// The flow without cells: Couette between the walls, the Poiseuille flow of the nominal rate, or
/// what plasma alone does between walls of any shape.
void add_flow_without_cells(const Model& m, VectorField<>& velocity, Field<>& density) {
    const double height = m.lattice.ny;
    const double mean = m.drive.target_velocity * m.drive.waveform.at(0.0);
    for (int j = 0; j < m.lattice.ny; ++j) {
        const double y = j + 0.5;
        const double couette = m.boundaries.bottom_speed +
                               (m.boundaries.top_speed - m.boundaries.bottom_speed) * y / height;
        const double poiseuille = 6.0 * mean * (y / height) * (1.0 - y / height);
        for (int i = 0; i < m.lattice.nx; ++i) {
            if (const UndisturbedFlow* plasma = m.undisturbed.get()) {
                velocity.x(i, j) = mean * plasma->velocity.x(i, j);
                velocity.y(i, j) = mean * plasma->velocity.y(i, j);
                density(i, j) = mean * m.viscosity.plasma * plasma->density(i, j);
            } else {
                velocity.x(i, j) = couette + poiseuille;
            }
        }
    }
}

/// What an observer sees of the ports before the first step.
void set_ports(const Model& m, FluidStart start, State& state) {
    if (!m.undisturbed || start == FluidStart::rest) return;
    const double unit = m.drive.target_velocity;
    for (const UndisturbedFlow::Port& port : m.undisturbed->ports) {
        const double density = unit * m.viscosity.plasma * port.density;
        const double inflow = unit * port.inflow;
        state.ports.push_back({{density, density}, {inflow, inflow}});
    }
}

/// Before the first step nodes move with the fluid around them: what an observer sees of them then,
/// and nothing else, follows from it.
template <class Real>
void let_nodes_follow(Sites<Real>& sites, Suspension& cells) {
    Periodic().fill(sites.velocity);
    for (int cell = 0; cell < cells.cell_count(); ++cell)
        interpolate(Order::zeroth, sites.stencils, sites.velocity, cells, cell);
}

/// The fluid in its flow and all that follows from the cells, which are there.
void start(const Case& c, const Model& model, State& state) {
    state.drive.body_force = model.drive.body_force;
    // Nothing is nearer than the reach of the contact forces; without them gaps are not measured.
    state.contact.smallest_gap = model.contact.range > 0.0 ? model.contact.range : std::nan("");
    VectorField<> velocity(model.lattice);
    Field<> density = density_of_drop(model);
    if (c.flow.start == FluidStart::developed) add_flow_without_cells(model, velocity, density);
    start_flow(model, velocity, density, state);
    set_ports(model, c.flow.start, state);
    derive(model, state);
    std::visit([&](auto& sites) { let_nodes_follow(sites, state.cells); }, state.sites);
}

/// The channel of a feed with its cells at random.
State feed_at_start(const Case& c, const Model& network, const Feed& feed,
                    const LayoutWatch& watch) {
    const Model& channel = *feed.channel;
    const FeedCase& asked = c.ports[static_cast<std::size_t>(feed.port)].feed;
    State state;
    const std::vector<Vec2> shape = stress_free_shape(c, channel.scales.length);
    const double cells = *asked.hematocrit * channel.open_area() / area_of(shape);
    const std::string& port = network.port_names[static_cast<std::size_t>(feed.port)];
    for (const Placement& place :
         random_placements(shape, std::max(1, static_cast<int>(std::lround(cells))),
                           {channel.lattice, channel.boundaries.walls.get()},
                           static_cast<std::uint64_t>(asked.seed.value_or(1)), watch,
                           fmt::format("[port.{}.feed]", port)))
        add_placed(shape, place, state.cells);
    start(c, channel, state);
    return state;
}

}  // namespace

State initial_state(const Case& c, const Model& model, const LayoutWatch& watch) {
    State state;
    state.cells = suspended_cells(c, model, watch);
    for (const Feed& feed : model.feeds)
        state.feeds.emplace_back().state = feed_at_start(c, model, feed, watch);
    if (admit_cells(model, state)) refuse_overlaps(model, state.cells);
    state.interior = {};
    start(c, model, state);
    return state;
}

}  // namespace tt
