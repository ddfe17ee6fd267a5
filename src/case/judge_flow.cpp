#include "case/judge_flow.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/channel_flow.hpp"
#include "case/kinds.hpp"
#include "case/membrane_of.hpp"
#include "case/step_limits.hpp"

namespace tt {
namespace {

/// Of G: what a case is told to take that asks for too much. Red cells at some 500 /s.
constexpr double usual_shear_number = 0.5;
/// Of G, for cells whose tension does not harden, drops too. In shear they ran at 3, and at 10 were
/// drawn out until their two sides met. In a channel, one neo-Hookean cell of 2.7 µm in 14 µm, a
/// circle or biconcave, at dx = 0.5 and 0.33 µm, k t = 60: all ran at 2, two of four broke at 2.5.
constexpr double largest_unhardened_in_shear = 3.0, largest_unhardened_in_channel = 2.0;
/// Of U H/ν, as run: a flow between two walls becomes turbulent at some thousands, which neither
/// two dimensions nor a few sites hold.
constexpr double largest_reynolds = 2000.0;

/// The key that asks for the flow, and what to write for one so many times as fast.
std::pair<std::string, std::string> flow_times(const FlowCase& flow, double factor) {
    std::pair<std::string, std::string> found;
    const auto look = [&](const char* key, const auto& value) {
        using Quantity = std::remove_cvref_t<decltype(*value)>;
        if (value) found = {key, rounded_text(Quantity{factor * value->si}, 2)};
    };
    if (const ChannelFlow* channel = flow.channel()) {
        look("pseudo_shear_rate", channel->pseudo_shear_rate);
        look("mean_velocity", channel->mean_velocity);
        look("largest_velocity", channel->largest_velocity);
        look("flow_rate", channel->flow_rate);
        look("wall_stress", channel->wall_stress);
        look("pressure_gradient", channel->pressure_gradient);
    }
    if (flow.shear()) look("shear_rate", flow.shear()->shear_rate);
    return found;
}

/// Shear rate, or pseudo-shear rate [1/s], that is asked for; nothing where none is, or its G.
std::optional<double> rate_of(const Case& c) {
    const ShearDrive* shear = c.flow.shear();
    if (std::holds_alternative<NoDrive>(c.flow.drive) || (shear && !shear->shear_rate)) return {};
    return std::abs((shear ? *shear->shear_rate : pseudo_shear_rate(c)).si);
}

/// Every flow is asked for by a number of its own; here all are held against one range. False where
/// it was left.
bool judge_rate(Judge& judge, const Case& c) {
    constexpr double slowest = 1e-6, fastest = 1e6;
    const auto asked = rate_of(c);
    if (!asked || (*asked >= slowest && *asked <= fastest)) return true;
    const double rate = *asked;
    const auto [key, value] = flow_times(
        c.flow, (rate < slowest ? 1.1 * slowest : 0.9 * fastest) / std::max(rate, 1e-300));
    const std::string write =
        rate == 0.0 ? "drive = \"none\" and leave " + key + " out" : key + " = \"" + value + "\"";
    judge.tell(
        {"flow.pseudo_shear_rate", "flow.mean_velocity", "flow.largest_velocity", "flow.flow_rate",
         "flow.wall_stress", "flow.pressure_gradient", "flow.shear_rate"},
        fmt::format("the flow has a {} rate of {:.4g} /s, and {} to {} /s are possible; write {}",
                    c.flow.shear() ? "shear" : "pseudo-shear", rate, to_text(slowest),
                    to_text(fastest), write));
    return false;
}

/// Does tension grow much faster than stretch before a membrane is half as long again?
bool hardens(const MembraneCase& membrane) {
    const Hardening hardening = hardening_of(membrane.hardening);
    return hardening.shear && hardening(1.5) > 2.0;
}

/// Cells in a flow that is so fast, or so viscous, for their membrane that no step and no grid
/// keeps them whole. The same limit as of shear_number.
void judge_shear_number(Judge& judge, const Case& c, double asked) {
    if (c.membrane.rigid) return;
    const double unhardened =
        c.flow.shear() ? largest_unhardened_in_shear : largest_unhardened_in_channel;
    const double largest = hardens(c.membrane) ? largest_shear_number : unhardened;
    const char* const why =
        hardens(c.membrane) ? "membranes would be torn"
                            : "cells whose tension does not harden are drawn out until they break";
    const ShearDrive* shear = c.flow.shear();
    if (shear && shear->shear_number && !shear->shear_rate) {
        if (asked > largest)
            judge.tell({"flow.shear_number"},
                       fmt::format("G = {} and at most {} is possible: {}; write shear_number = {}",
                                   to_text(asked), largest, why,
                                   rounded_text(usual_shear_number * *shear->shear_number / asked,
                                                Dimension{}, 2)));
        return;
    }
    const double shear_number = shear_number_at(c, Rate{rate_of(c).value_or(0.0)});
    if (shear_number <= largest) return;
    const auto [key, value] = flow_times(c.flow, usual_shear_number / shear_number);
    judge.tell(
        {"flow." + key, "plasma.viscosity", "membrane.shear_modulus"},
        fmt::format("G = mu k a / E_s is {:.3g}, and at most {} is possible: {}; look at the units "
                    "of viscosity and shear_modulus, or write {} = \"{}\"",
                    shear_number, largest, why, key, value));
}

/// Of a straight channel, where the width is that of the flow.
void judge_reynolds(Judge& judge, const Case& c) {
    const double width = c.domain.width.si, scale = c.numerics.density_scale.value_or(1.0);
    const double physical =
        c.plasma.density.si * rate_of(c).value_or(0.0) * width * width / c.plasma.viscosity.si;
    if (!c.geometry.straight() || !(physical * scale > largest_reynolds)) return;
    if (physical <= largest_reynolds) {
        judge.tell(
            {"numerics.density_scale"},
            fmt::format("density_scale = {} makes the Reynolds number of the channel {:.3g}, "
                        "and beyond {:g} a flow is turbulent; write density_scale = {:.0f}, "
                        "or leave it out",
                        to_text(scale), physical * scale, largest_reynolds,
                        std::max(1.0, 0.05 * largest_reynolds / physical)));
        return;
    }
    const auto [key, value] = flow_times(c.flow, 0.05 * largest_reynolds / (physical * scale));
    judge.tell({"flow." + key, "plasma.viscosity"},
               fmt::format("the Reynolds number rho U H / mu is {:.3g}, and beyond {:g} a flow is "
                           "turbulent, which two dimensions do not hold; look at the units, or "
                           "write {} = \"{}\"",
                           physical * scale, largest_reynolds, key, value));
}

}  // namespace

void judge_flow(Judge& judge, const Case& c, bool with_cells) {
    if (!judge_rate(judge, c)) return;
    judge_reynolds(judge, c);
    if (!with_cells) return;
    // A number that is asked for is that of the first kind.
    const std::vector<Case> kinds = cases_by_kind(c);
    const auto time = [](const Case& one) {
        return equivalent_radius(one).si / one.membrane.shear_modulus.si;
    };
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        if (!c.kinds.empty()) judge.look_at_kind(c.kinds[n].name);
        const double first = c.flow.shear() ? c.flow.shear()->shear_number.value_or(0.0) : 0.0;
        judge_shear_number(judge, kinds[n],
                           n == 0 ? first : first * (time(kinds[n]) / time(kinds.front())));
    }
    judge.look_at_kind({});
}

}  // namespace tt
