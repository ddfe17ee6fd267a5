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
#include "case/judge_cells.hpp"
#include "case/judge_channels.hpp"
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
