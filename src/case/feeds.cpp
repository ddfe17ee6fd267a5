#include "case/feeds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/kinds.hpp"
#include "case/openings.hpp"

namespace tt {
namespace {

/// A port on the lattice of a network: x along its flow, y across, whichever way it faces.
struct Gate {
    Vec2 in;           ///< direction into the network
    bool upright;      ///< it lies along x: in is along y
    int plane;         ///< the line between two rows or columns of sites where it is
    double low, high;  ///< its ends

    double width() const { return high - low; }
    int first() const { return static_cast<int>(std::floor(low)); }
    int last() const { return static_cast<int>(std::ceil(high)); }
};

Gate gate_of(const Walls& walls, std::size_t port) {
    const LatticeOpening& place = walls.openings[port];
    const Opening& opening = walls.solid.openings[port];
    const auto link = std::find_if(
        walls.inflow.begin(), walls.inflow.end(),
        [&](const OpeningLink& l) { return static_cast<std::size_t>(l.opening) == port; });
    const bool upright = place.out_y != 0;
    const int inside = upright ? link->j : link->i;
    const int out = upright ? place.out_y : place.out_x;
    const auto [low, high] = upright ? std::minmax(opening.from.x, opening.to.x)
                                     : std::minmax(opening.from.y, opening.to.y);
    return {{-static_cast<double>(place.out_x), -static_cast<double>(place.out_y)},
            upright,
            inside + (out > 0 ? 1 : 0),
            low,
            high};
}

/// Two walls, at rest, as far from the lattice as those of the network are.
Solid solid_of_channel(const Gate& gate, const Lattice& lattice) {
    const double margin = network_margin - gate.first();
    const double from = gate.high + margin, to = gate.low + margin;
    const double nx = lattice.nx, ny = lattice.ny;
    Solid solid;
    solid.period_x = nx;
    solid.period_y = ny;
    // From one wall round to the other.
    if (gate.upright)
        solid.loops = {{{from, 0.0}, {to + nx, 0.0}, {to + nx, ny}, {from, ny}}};
    else
        solid.loops = {{{0.0, from}, {nx, from}, {nx, to + ny}, {0.0, to + ny}}};
    return solid;
}

/// Poiseuille flow of mean velocity 1 between the walls; what passes, a sum over sites, is more
/// than the integral by as much as in the network.
UndisturbedFlow poiseuille(const Gate& gate, const Walls& walls, double sampled) {
    const Lattice& lattice = walls.lattice;
    const double low = gate.low + network_margin - gate.first(), width = gate.width();
    UndisturbedFlow flow;
    flow.velocity = VectorField<>(lattice);
    flow.density = Field<>(lattice);
    const auto profile = [&](int site) {
        const double share = (site + 0.5 - low) / width;
        return 6.0 * share * (1.0 - share);
    };
    const int across = gate.upright ? lattice.nx : lattice.ny;
    double passing = 0.0;
    for (int k = 0; k < across; ++k)
        if (gate.upright ? walls.is_open(k, 0) : walls.is_open(0, k)) passing += profile(k);
    const double unit = sampled * width / passing;
    for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) {
            if (!walls.is_open(i, j)) continue;
            const double u = unit * profile(gate.upright ? i : j);
            flow.velocity.x(i, j) = u * gate.in.x;
            flow.velocity.y(i, j) = u * gate.in.y;
        }
    flow.conductance = width * width * width / 12.0;
    flow.site_mean = sampled * width / across;
    flow.fastest = 1.5;
    flow.steepest = 6.0 / width;
    return flow;
}

Model channel_of(const Gate& gate, int period, double mean_velocity, const Model& network) {
    const int across = gate.last() - gate.first() + 2 * network_margin;
    Model m = network;
    m.lattice = gate.upright ? Lattice{across, period, false} : Lattice{period, across, false};
    const auto walls =
        std::make_shared<const Walls>(make_walls(solid_of_channel(gate, m.lattice), m.lattice));
    m.boundaries = {};
    m.boundaries.walls = m.contact.walls = walls;
    m.port_names = {};
    m.port_waves = {};
    m.exits = {};
    m.feeds = {};
    m.sections = {};
    m.forks = {};
    m.stretches = {};
    m.undisturbed = std::make_shared<const UndisturbedFlow>(
        poiseuille(gate, *walls, network.boundaries.walls->sampled_flow()));
    m.drive = {};
    m.drive.direction = gate.in;
    m.drive.width = gate.width();
    m.drive.hold_mean_velocity = true;
    m.drive.target_velocity = mean_velocity;
    m.drive.body_force = 12.0 * m.viscosity.plasma * mean_velocity / (gate.width() * gate.width());
    return m;
}

}  // namespace

Length room_at_feed(const Case& c) { return Length{6.0 * largest_cell_radius(c).si}; }

Length feed_length(const Case& c, const FeedCase& feed, Length port_width) {
    return feed.length.value_or(Length{std::max(10.0 * port_width.si, 4.0 * room_at_feed(c).si)});
}

std::vector<std::string> faults_of_feeds(const Case& c, const Choice& choice, const Walls& walls) {
    std::vector<std::string> faults;
    const int room = static_cast<int>(std::ceil(room_at_feed(c).si / choice.dx.si));
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        if (!lets_cells_in(c, c.ports[n]) || walls.openings[n].width == 0) continue;
        const Gate gate = gate_of(walls, n);
        const int in = static_cast<int>(gate.in.x + gate.in.y);
        bool behind = false, before = false;
        for (int step = 0; step < room; ++step)
            for (int k = static_cast<int>(std::ceil(gate.low - 0.5)); k + 0.5 < gate.high; ++k) {
                const auto open = [&](int along) {
                    const int i = gate.upright ? k : along, j = gate.upright ? along : k;
                    return i >= 0 && i < choice.nx && j >= 0 && j < choice.ny &&
                           walls.is_open(i, j);
                };
                const int ahead = gate.plane + (in > 0 ? step : -1 - step);
                const int back = gate.plane + (in > 0 ? -1 - step : step);
                before = before || !open(ahead);
                behind = behind || open(back);
            }
        const std::string length = rounded_text(room_at_feed(c), 3);
        if (before)
            faults.push_back(
                fmt::format("[port.{}.feed] cells take a straight channel of {} behind "
                            "the port to come in; draw it longer there",
                            c.ports[n].name, length));
        if (behind)
            faults.push_back(
                fmt::format("[port.{}.feed] another channel is within {} outside of "
                            "the port; draw them farther apart",
                            c.ports[n].name, length));
    }
    return faults;
}

std::vector<Feed> feeds_of(const Case& c, const Choice& choice, const Model& network) {
    std::vector<Feed> list;
    const Walls& walls = *network.boundaries.walls;
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        if (!lets_cells_in(c, c.ports[n])) continue;
        const Gate gate = gate_of(walls, n);
        const double dx = choice.dx.si;
        const Length length = feed_length(c, c.ports[n].feed, Length{gate.width() * dx});
        const auto& held = std::get<HeldInflow>(network.boundaries.ports[n]);
        Feed feed;
        feed.period = static_cast<int>(std::lround(length.si / dx));
        feed.port = static_cast<int>(n);
        feed.in = gate.in;
        feed.i = gate.upright ? gate.first() - network_margin : gate.plane;
        feed.j = gate.upright ? gate.plane : gate.first() - network_margin;
        feed.room = room_at_feed(c).si / dx;
        feed.channel = std::make_shared<const Model>(channel_of(
            gate, feed.period, held.rate / (walls.sampled_flow() * gate.width()), network));
        list.push_back(std::move(feed));
    }
    return list;
}

Walls with_closed_ports(const Model& network) {
    Solid solid = network.boundaries.walls->solid;
    std::vector<double> depth(network.exits.size(), kernel_reach);
    for (const Feed& feed : network.feeds) depth[static_cast<std::size_t>(feed.port)] = feed.room;
    for (std::size_t n = 0; n < network.exits.size(); ++n) {
        const Exit& port = network.exits[n];
        const Vec2 in = -depth[n] * port.out;
        solid.loops.push_back({port.from, port.to, port.to + in, port.from + in});
    }
    return make_walls(solid, network.lattice);
}

}  // namespace tt
