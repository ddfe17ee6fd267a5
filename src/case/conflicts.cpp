#include "case/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "case/channel_flow.hpp"
#include "case/judge.hpp"
#include "case/sections.hpp"
#include "case/table_names.hpp"

namespace tt {
namespace {

void judge_exclusive(Judge& judge) {
    for (const Exclusive& exclusive : exclusive_keys) {
        std::string first;
        for (const std::string_view key : exclusive.keys) {
            const std::string path = fmt::format("{}.{}", exclusive.table, key);
            if (!judge.given(path)) continue;
            if (!first.empty())
                judge.tell({path}, fmt::format("{} and {} are both given; leave one of them out",
                                               first, key));
            if (first.empty()) first = key;
        }
    }
}

void judge_channel(Judge& judge, const FlowCase& flow) {
    const auto given = [&](std::string_view key) {
        return judge.given(fmt::format("flow.{}", key));
    };
    if (std::none_of(channel_flow_keys.begin(), channel_flow_keys.end(), given))
        judge.tell(
            {"flow.drive"},
            fmt::format("drive = \"{}\" needs pseudo_shear_rate = \"500 /s\", or one of {}",
                        word_of(flow.drive),
                        fmt::join(channel_flow_keys.begin() + 1, channel_flow_keys.end(), ", ")));
    if (flow.channel()->hold == Hold::mean_velocity && !given("pseudo_shear_rate") &&
        !given("mean_velocity") && !given("flow_rate"))
        judge.tell({"flow.hold"},
                   "hold = \"mean-velocity\" needs pseudo_shear_rate, mean_velocity or flow_rate: "
                   "what to hold");
}

/// What changes in time, at `path`, of something that can (`why` not is empty).
void judge_wave(Judge& judge, const WaveCase& wave, const std::string& path,
                const std::string& why) {
    if (std::holds_alternative<SteadyWave>(wave)) return;
    if (!why.empty()) return judge.tell({path + ".waveform"}, why);
    const auto* table = std::get_if<TableWave>(&wave);
    if (!table) return;
    const auto& times = table->times;
    const bool rising = times.size() > 1 && times.front().si == 0.0 &&
                        std::adjacent_find(times.begin(), times.end(),
                                           [](Time a, Time b) { return !(a < b); }) == times.end();
    if (!rising)
        judge.tell({path + ".times", path + ".waveform"},
                   "times are two or more, the first 0 and each later than the one before; write "
                   "times = [\"0 s\", \"0.3 s\", \"1 s\"]");
    if (table->factors.size() != times.size())
        judge.tell({path + ".factors", path + ".waveform"},
                   fmt::format("there are {} factors and {} times; write a factor for each",
                               table->factors.size(), times.size()));
}

void judge_flow(Judge& judge, const Case& c) {
    const FlowCase& flow = c.flow;
    judge_wave(judge, flow.waveform, "flow",
               c.network() ? "of channels between ports each port has its own; write waveform in "
                             "[port.NAME]"
               : !flow.channel()
                   ? fmt::format("drive = \"{}\" does not change in time; write drive = "
                                 "\"pressure\", or leave waveform out",
                                 word_of(flow.drive))
               : flow.channel()->hold == Hold::mean_velocity
                   ? "a mean velocity that is held does not change in time; leave hold out"
                   : "");
    if (flow.channel()) judge_channel(judge, flow);
    if (flow.shear() && !judge.given("flow.shear_rate") && !judge.given("flow.shear_number"))
        judge.tell({"flow.drive"},
                   "drive = \"shear\" needs shear_rate = \"75 /s\" or shear_number = 0.2");
    const bool posts = !c.geometry.straight();  // something that holds the flow
    if (!std::holds_alternative<NoDrive>(flow.drive) && c.domain.sides == Sides::periodic && !posts)
        judge.tell(
            {"domain.sides"},
            fmt::format("drive = \"{}\" needs walls; write sides = \"walls\" or drive = \"none\"",
                        word_of(flow.drive)));
    if (judge.given("flow.shear_number") && c.numerics.fluid_only)
        judge.tell({"flow.shear_number"},
                   "shear_number is built on the cells, and there are none; write shear_rate");
}

/// What is meant for a straight channel only.
void judge_geometry(Judge& judge, const Case& c) {
    if (c.geometry.straight()) return;
    const std::string why = fmt::format("between walls of shape \"{}\"", word_of(c.geometry.shape));
    judge.forbid("flow.largest_velocity",
                 why + " (write mean_velocity, over the width of the box)");
    judge.forbid("flow.wall_stress", why + " (write mean_velocity, over the width of the box)");
    judge.forbid("layer.thickness", why);
    if (c.flow.shear())
        judge.tell({"flow.drive"},
                   "drive = \"shear\" needs a straight channel; write drive = \"pressure\"");
    if (const auto* posts = std::get_if<PostsShape>(&c.geometry.shape)) {
        const double turns = posts->row_shift * static_cast<double>(posts->columns);
        if (c.domain.sides == Sides::periodic && std::fabs(turns - std::round(turns)) > 1e-6)
            judge.tell({"geometry.row_shift", "geometry.columns"},
                       fmt::format("row_shift = {} over {} columns does not close on itself at the "
                                   "ends of the box: their product must be a whole number",
                                   posts->row_shift, posts->columns));
    }
}

/// Cells that come in.
void judge_feed(Judge& judge, const Case& c, const PortCase& port) {
    const std::string path = fmt::format("port.{}.feed", port.name);
    const auto key = [&](std::string_view name) { return fmt::format("{}.{}", path, name); };
    if (!port.feeds()) {
        for (const std::string_view name : {"length", "seed"})
            if (judge.given(key(name)))
                judge.tell({key(name)}, fmt::format("{} means nothing without cells; write "
                                                    "hematocrit = \"20 %\" beside it",
                                                    name));
        return;
    }
    const double flow = port.mean_velocity ? port.mean_velocity->si
                        : port.flow_rate   ? port.flow_rate->si
                                           : 0.0;
    if (!(flow > 0.0))
        judge.tell({key("hematocrit")},
                   fmt::format("port '{}' lets cells in and must hold a flow into the channels; "
                               "write mean_velocity = \"1 mm/s\" in [port.{}]",
                               port.name, port.name));
}

void judge_port(Judge& judge, const Case& c, const PortCase& port) {
    const std::string path = "port." + port.name;
    const auto key = [&](std::string_view name) { return fmt::format("{}.{}", path, name); };
    if (!is_table_name(port.name)) judge.tell({path}, table_name_fault("port"));
    const std::vector<std::string_view> own = c.geometry.port_names();
    if (!own.empty() && !port.at.empty())
        judge.tell({key("at"), path}, fmt::format("at means nothing with shape = \"{}\", whose "
                                                  "ports have names; leave it out",
                                                  word_of(c.geometry.shape)));
    if (!own.empty() && std::find(own.begin(), own.end(), port.name) == own.end())
        judge.tell({path}, fmt::format("the ports of shape = \"{}\" are {}; write one of these "
                                       "names",
                                       word_of(c.geometry.shape), fmt::join(own, ", ")));
    if (own.empty() && port.at.size() != 2)
        judge.tell({key("at"), path},
                   "at is a point on the port; write at = [\"0 um\", \"10 um\"]");
    std::string given;
    for (const std::string_view name : {"pressure", "flow_rate", "mean_velocity"}) {
        if (!judge.given(key(name))) continue;
        if (!given.empty())
            judge.tell({key(name)},
                       fmt::format("{} and {} are both given; leave one of them out", given, name));
        given = name;
    }
    if (given.empty())
        judge.tell({path},
                   "nothing is asked of this port; write pressure = \"0 Pa\", flow_rate = "
                   "\"0.02 mm^2/s\" or mean_velocity = \"1 mm/s\"");
    judge_wave(judge, port.waveform, path,
               port.feeds() ? "cells come in with a steady flow; leave waveform out here" : "");
    judge_feed(judge, c, port);
    if (own.empty() && !std::holds_alternative<DrawnShape>(c.geometry.shape))
        judge.tell({path}, fmt::format("a port means nothing with shape = \"{}\"; write shape = "
                                       "\"file\", or one of the channels between ports, in "
                                       "[geometry]",
                                       word_of(c.geometry.shape)));
}

/// Channels between ports: what drives the flow are they, and the box is that of the drawing.
void judge_ports(Judge& judge, const Case& c) {
    for (const std::string_view own : c.geometry.port_names())
        if (std::none_of(c.ports.begin(), c.ports.end(),
                         [&](const PortCase& port) { return port.name == own; }))
            judge.tell({"geometry.shape"},
                       fmt::format("shape = \"{}\" has a port '{}'; write [port.{}] with pressure, "
                                   "flow_rate or mean_velocity",
                                   word_of(c.geometry.shape), own, own));
    if (!c.network()) return;
    for (const PortCase& port : c.ports) judge_port(judge, c, port);
    const auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape);
    if (drawn && drawn->fluid == Side::outside)
        judge.tell({"geometry.fluid"},
                   "fluid = \"outside\" has no channels between ports; write fluid = \"inside\"");
    const std::string first = "port." + c.ports.front().name;
    if (c.ports.size() < 2)
        judge.tell({first},
                   "one port alone: what goes in must come out; write another [port.NAME]");
    else if (std::none_of(c.ports.begin(), c.ports.end(),
                          [](const PortCase& port) { return port.pressure.has_value(); }))
        judge.tell({first},
                   "every port holds a flow; where they do not add up to nothing the fluid has "
                   "nowhere to go: write pressure = \"0 Pa\" for one of them");
    if (!std::holds_alternative<NoDrive>(c.flow.drive))
        judge.tell({"flow.drive"}, fmt::format("drive = \"{}\" means nothing with ports, which "
                                               "drive the flow; leave it out",
                                               word_of(c.flow.drive)));
    if (c.numerics.equilibrium && std::holds_alternative<FullEquilibrium>(*c.numerics.equilibrium))
        judge.tell({"numerics.equilibrium"},
                   "equilibrium = \"full\" is not possible with ports, whose pressures would "
                   "change the density; leave it out");
}

void judge_positions_given(Judge& judge, const Case& c, const AtPositions& layout) {
    if (layout.positions.empty())
        judge.tell(
            {"cells.layout"},
            fmt::format("layout = \"explicit\" needs the centre of each cell; write positions "
                        "= [[\"{}\", \"{}\"]]",
                        to_text(Length{0.5 * c.domain.length.si}),
                        to_text(Length{0.5 * c.domain.width.si})));
    for (const auto& position : layout.positions)
        if (position.size() != 2) {
            judge.tell({"cells.positions"},
                       "each of positions is a pair, as in [[\"20 um\", \"10 um\"]]");
            break;
        }
    if (c.cells.count && !layout.positions.empty() &&
        *c.cells.count != static_cast<std::int64_t>(layout.positions.size()))
        judge.tell({"cells.count"},
                   fmt::format("count = {}, but there are {} positions; leave count out",
                               *c.cells.count, layout.positions.size()));
}

/// Cells that are laid at random lie at any angle, and fit as they are at rest.
void judge_random(Judge& judge, const CellsCase& cells) {
    if (cells.angle.si != 0.0)
        judge.tell(
            {"cells.angle"},
            "angle means nothing with layout = \"random\", which turns each cell by an angle of "
            "its own; leave it out");
    if (cells.initial_stretch)
        judge.tell(
            {"cells.initial_stretch"},
            fmt::format("initial_stretch = {} is not possible with layout = \"random\", which "
                        "lays cells as they are at rest; leave it out, or write layout = "
                        "\"explicit\"",
                        to_text(*cells.initial_stretch)));
}

void judge_layout(Judge& judge, const Case& c) {
    const CellsCase& cells = c.cells;
    const bool single = std::holds_alternative<SingleCell>(cells.layout);
    const auto* positions = std::get_if<AtPositions>(&cells.layout);
    if (single || positions)
        judge.forbid("cells.hematocrit",
                     fmt::format("with layout = \"{}\"", word_of(cells.layout)));
    else if (!judge.given("cells.count") && !judge.given("cells.hematocrit"))
        judge.tell({"cells.layout"},
                   fmt::format("layout = \"{}\" needs count = 12 or hematocrit = \"38 %\"",
                               word_of(cells.layout)));
    if (single && cells.count.value_or(1) > 1)
        judge.tell({"cells.count"},
                   "layout = \"single\" is one cell; write layout = \"paper\" or \"random\"");
    if (std::holds_alternative<PaperRows>(cells.layout) && cells.count.value_or(2) % 2 != 0)
        judge.tell({"cells.count"},
                   fmt::format("layout = \"paper\" is two equal rows; write count = {}",
                               *cells.count + 1));
    if (positions) judge_positions_given(judge, c, *positions);
    if (std::holds_alternative<AtRandom>(cells.layout)) judge_random(judge, cells);
}

void judge_cells(Judge& judge, const Case& c) {
    if (c.numerics.fluid_only) return;
    if (!judge.given_any("cells."))
        return judge.tell({},
                          "there is no [cells]; write one, or fluid_only = true in [numerics] for "
                          "a plain channel");
    judge_layout(judge, c);
}

void judge_numerics(Judge& judge) {
    if (judge.given("numerics.dx") && judge.given("numerics.dt") &&
        judge.given("numerics.relaxation_time") && judge.given("numerics.density_scale"))
        judge.tell({"numerics.dt"},
                   "dx, dt, relaxation_time and density_scale are tied by viscosity; give at most "
                   "three of them");
    if (judge.given("layer.thickness") != judge.given("layer.viscosity"))
        judge.tell({"layer.thickness", "layer.viscosity"},
                   "[layer] needs both thickness and viscosity");
}

}  // namespace

std::vector<Fault> find_conflicts(const Case& c, const Places& places, const std::string& file) {
    Judge judge(places, file);
    judge_exclusive(judge);
    judge_flow(judge, c);
    judge_geometry(judge, c);
    judge_ports(judge, c);
    judge_section_keys(judge, c);
    judge_cells(judge, c);
    judge_numerics(judge);
    return std::move(judge.faults);
}

}  // namespace tt
