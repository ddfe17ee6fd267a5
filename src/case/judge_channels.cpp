#include "case/judge_channels.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/feeds.hpp"
#include "case/table_names.hpp"

namespace tt {
namespace {

/// Cells that come in.
void judge_feed(Judge& judge, const PortCase& port) {
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
    judge_feed(judge, port);
    if (own.empty() && !std::holds_alternative<DrawnShape>(c.geometry.shape))
        judge.tell({path}, fmt::format("a port means nothing with shape = \"{}\"; write shape = "
                                       "\"file\", or one of the channels between ports, in "
                                       "[geometry]",
                                       word_of(c.geometry.shape)));
}

}  // namespace

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
                   fmt::format("there are {} factors and {} times; a factor for each, write "
                               "factors = [{}]",
                               table->factors.size(), times.size(),
                               fmt::join(std::vector<int>(times.size(), 1), ", ")));
}

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

void judge_feeds(Judge& judge, const Case& c) {
    for (const PortCase& port : c.ports) {
        if (!lets_cells_in(c, port) || !port.feed.length) continue;
        const Length least{4.0 * room_at_feed(c).si};
        if (*port.feed.length < least)
            judge.tell({fmt::format("port.{}.feed.length", port.name)},
                       fmt::format("the channel that feeds is {} long and takes room for some "
                                   "cells; write length = \"{}\", or leave it out",
                                   to_text(*port.feed.length), rounded_text(least, 3)));
    }
}

void judge_walls(Judge& judge, const Case& c) {
    const DomainCase& box = c.domain;
    if (const auto* stenosis = std::get_if<StenosisShape>(&c.geometry.shape)) {
        if (box.sides != Sides::walls)
            judge.tell({"domain.sides"},
                       "a stenosis narrows the way between two walls; write sides = \"walls\"");
        if (stenosis->throat >= box.width)
            judge.tell(
                {"geometry.throat"},
                fmt::format("the throat is {} wide and the channel {}; write throat = \"{}\"",
                            to_text(stenosis->throat), to_text(box.width),
                            rounded_text(Length{0.5 * box.width.si}, 3)));
        if (stenosis->throat_length > box.length)
            judge.tell({"geometry.throat_length"},
                       fmt::format("the throat is {} long and the channel {}; write "
                                   "throat_length = \"{}\", or a longer channel",
                                   to_text(stenosis->throat_length), to_text(box.length),
                                   rounded_text(Length{0.5 * box.length.si}, 3)));
    }
    if (const auto* posts = std::get_if<PostsShape>(&c.geometry.shape)) {
        const double nearest = std::min(box.length.si / static_cast<double>(posts->columns),
                                        box.width.si / static_cast<double>(posts->rows));
        if (posts->diameter.si >= nearest)
            judge.tell({"geometry.diameter"},
                       fmt::format("posts of {} that stand {} apart leave no gap; write diameter = "
                                   "\"{}\", or fewer columns and rows",
                                   to_text(posts->diameter), rounded_text(Length{nearest}, 4),
                                   rounded_text(Length{0.5 * nearest}, 3)));
    }
}

}  // namespace tt
