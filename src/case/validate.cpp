#include "case/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/units.hpp"
#include "case/channel_flow.hpp"
#include "case/fit.hpp"
#include "case/contact_at_start.hpp"
#include "case/judge.hpp"
#include "membrane/in_plane/surface_tension.hpp"

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
    const std::string why = fmt::format("with drive = \"{}\"", flow.drive);
    judge.forbid("flow.shear_rate", why);
    judge.forbid("flow.shear_number", why);
    const auto given = [&](std::string_view key) {
        return judge.given(fmt::format("flow.{}", key));
    };
    if (std::none_of(channel_flow_keys.begin(), channel_flow_keys.end(), given))
        judge.tell(
            {"flow.drive"},
            fmt::format("drive = \"{}\" needs pseudo_shear_rate = \"500 /s\", or one of {}",
                        flow.drive,
                        fmt::join(channel_flow_keys.begin() + 1, channel_flow_keys.end(), ", ")));
    if (flow.hold == "mean-velocity" && !given("pseudo_shear_rate") && !given("mean_velocity") &&
        !given("flow_rate"))
        judge.tell({"flow.hold"},
                   "hold = \"mean-velocity\" needs pseudo_shear_rate, mean_velocity or flow_rate: "
                   "what to hold");
}

void judge_flow(Judge& judge, const Case& c) {
    const FlowCase& flow = c.flow;
    if (flow.drive == "pressure" || flow.drive == "body-force") judge_channel(judge, flow);
    if (flow.drive == "shear" || flow.drive == "none") {
        const std::string why = fmt::format("with drive = \"{}\"", flow.drive);
        for (const std::string_view key : channel_flow_keys)
            judge.forbid(fmt::format("flow.{}", key), why);
    }
    if (flow.drive == "none") {
        judge.forbid("flow.shear_rate", "with drive = \"none\"");
        judge.forbid("flow.shear_number", "with drive = \"none\"");
    }
    if (flow.drive == "shear" && !judge.given("flow.shear_rate") &&
        !judge.given("flow.shear_number"))
        judge.tell({"flow.drive"},
                   "drive = \"shear\" needs shear_rate = \"75 /s\" or shear_number = 0.2");
    if (flow.drive != "none" && c.domain.sides == "periodic")
        judge.tell(
            {"domain.sides"},
            fmt::format("drive = \"{}\" needs walls; write sides = \"walls\" or drive = \"none\"",
                        flow.drive));
    if (judge.given("flow.shear_number") && c.numerics.fluid_only)
        judge.tell({"flow.shear_number"},
                   "shear_number is built on the cells, and there are none; write shear_rate");
}

void judge_layout(Judge& judge, const Case& c) {
    const CellsCase& cells = c.cells;
    const bool numbered = judge.given("cells.count") || judge.given("cells.hematocrit");
    if ((cells.layout == "paper" || cells.layout == "random") && !numbered)
        judge.tell(
            {"cells.layout"},
            fmt::format("layout = \"{}\" needs count = 12 or hematocrit = \"38 %\"", cells.layout));
    if (cells.layout == "single" && cells.count.value_or(1) > 1)
        judge.tell({"cells.count"},
                   "layout = \"single\" is one cell; write layout = \"paper\" or \"random\"");
    if (cells.layout == "single" || cells.layout == "explicit")
        judge.forbid("cells.hematocrit", fmt::format("with layout = \"{}\"", cells.layout));
    if (cells.layout == "paper" && cells.count.value_or(2) % 2 != 0)
        judge.tell({"cells.count"},
                   fmt::format("layout = \"paper\" is two equal rows; write count = {}",
                               *cells.count + 1));
    if (cells.layout == "explicit" && cells.positions.empty())
        judge.tell(
            {"cells.layout"},
            fmt::format("layout = \"explicit\" needs the centre of each cell; write positions "
                        "= [[\"{}\", \"{}\"]]",
                        to_text(Length{0.5 * c.domain.length.si}),
                        to_text(Length{0.5 * c.domain.width.si})));
    if (cells.layout != "explicit" && !cells.positions.empty())
        judge.forbid("cells.positions", fmt::format("with layout = \"{}\"", cells.layout));
    for (const auto& position : cells.positions)
        if (position.size() != 2) {
            judge.tell({"cells.positions"},
                       "each of positions is a pair, as in [[\"20 um\", \"10 um\"]]");
            break;
        }
    if (cells.layout == "explicit" && cells.count && !cells.positions.empty() &&
        *cells.count != static_cast<std::int64_t>(cells.positions.size()))
        judge.tell({"cells.count"},
                   fmt::format("count = {}, but there are {} positions; leave count out",
                               *cells.count, cells.positions.size()));
}

void judge_cells(Judge& judge, const Case& c) {
    const CellsCase& cells = c.cells;
    if (c.numerics.fluid_only) return;
    if (!judge.given_any("cells."))
        return judge.tell({},
                          "there is no [cells]; write one, or fluid_only = true in [numerics] for "
                          "a plain channel");
    judge_layout(judge, c);
    const std::string why = fmt::format("with shape = \"{}\"", cells.shape);
    if (cells.shape != "ellipse") judge.forbid("cells.aspect_ratio", why);
    if (cells.shape != "file")
        for (const char* key : {"cells.file", "cells.pixel", "cells.y_down", "cells.smoothing"})
            judge.forbid(key, why);
    if (cells.shape == "ellipse" && !judge.given("cells.aspect_ratio"))
        judge.tell({"cells.shape"}, "shape = \"ellipse\" needs aspect_ratio = 1.5");
    if (cells.shape == "file" && !judge.given("cells.file"))
        judge.tell({"cells.shape"}, "shape = \"file\" needs file = \"outline.csv\"");
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

/// Whether the outline of a file has the size of a cell. In another unit than it is read in it is
/// far too large, and would be made of any number of nodes, or far too small.
bool judge_outline(Judge& judge, const Case& c) {
    if (!c.cells.outline) return true;
    const OutlineMeasures m = measures_of(*c.cells.outline);
    const std::string size = fmt::format("the outline is {} by {}", rounded_text(Length{m.width}),
                                         rounded_text(Length{m.height}));
    const char* const unit =
        "pixel in [cells] tells the unit of its numbers: pixel = \"0.1 um\", or \"1 mm\"";
    if (std::max(m.width, m.height) > std::hypot(c.domain.length.si, c.domain.width.si))
        judge.tell({"cells.file"},
                   fmt::format("{}, longer than the box, {} by {}; {}", size,
                               to_text(c.domain.length), to_text(c.domain.width), unit));
    else if (m.radius < smallest_radius)
        judge.tell({"cells.file"}, fmt::format("{}, smaller than any cell{}{}; {}", size,
                                               c.numerics.dx ? " and than dx = " : "",
                                               c.numerics.dx ? to_text(*c.numerics.dx) : "", unit));
    else
        return true;
    return false;
}

void judge_membrane(Judge& judge, const MembraneCase& membrane) {
    std::vector<std::string> hardened = membrane.hardening.apply_to;
    if (membrane.law == SurfaceTension::name && std::erase(hardened, "shear") > 0)
        judge.tell({"membrane.law"},
                   fmt::format("a drop of constant surface tension does not harden: in "
                               "[membrane.hardening] write apply_to = [\"{}\"]",
                               fmt::join(hardened, "\", \"")));
}

void judge_contact(Judge& judge, const ContactCase& contact) {
    if (contact.model == "none") return;
    if (contact.energy.si > lysis_tension)
        judge.tell(
            {"contact.energy"},
            fmt::format(
                "energy = {} J/m^2 is {:.3g} times the tension at which the membrane bursts (about "
                "{} N/m); "
                "the paper prints uJ/um^2 but can only mean J/m^2: write energy = \"1.3e-7 J/m^2\"",
                to_text(contact.energy.si), contact.energy.si / lysis_tension,
                to_text(lysis_tension)));
    if (contact.range && *contact.range <= contact.zero_force_distance)
        judge.tell({"contact.range"},
                   fmt::format("range = {} must exceed zero_force_distance, {}; leave it out",
                               to_text(*contact.range), to_text(contact.zero_force_distance)));
}

/// The key that asks for the flow, and what to write for one so many times as fast.
std::pair<std::string, std::string> flow_times(const FlowCase& flow, double factor) {
    std::pair<std::string, std::string> found;
    const auto look = [&](const char* key, const auto& value) {
        using Quantity = std::remove_cvref_t<decltype(*value)>;
        if (value) found = {key, rounded_text(Quantity{factor * value->si}, 2)};
    };
    look("pseudo_shear_rate", flow.pseudo_shear_rate);
    look("mean_velocity", flow.mean_velocity);
    look("largest_velocity", flow.largest_velocity);
    look("flow_rate", flow.flow_rate);
    look("wall_stress", flow.wall_stress);
    look("pressure_gradient", flow.pressure_gradient);
    look("shear_rate", flow.shear_rate);
    return found;
}

/// Every flow is asked for by a number of its own; here all are held against one range.
void judge_rate(Judge& judge, const Case& c) {
    constexpr double slowest = 1e-6, fastest = 1e6;
    const bool shear = c.flow.drive == "shear";
    if (c.flow.drive == "none" || (shear && !c.flow.shear_rate)) return;
    const double rate = std::abs((shear ? *c.flow.shear_rate : pseudo_shear_rate(c)).si);
    if (rate >= slowest && rate <= fastest) return;
    const auto [key, value] =
        flow_times(c.flow, (rate < slowest ? 1.1 * slowest : 0.9 * fastest) / rate);
    judge.tell(
        {"flow.pseudo_shear_rate", "flow.mean_velocity", "flow.largest_velocity", "flow.flow_rate",
         "flow.wall_stress", "flow.pressure_gradient", "flow.shear_rate"},
        fmt::format("the flow has a {} rate of {} /s, and {} to {} /s are possible; write {} = "
                    "\"{}\"",
                    shear ? "shear" : "pseudo-shear", to_text(rate), to_text(slowest),
                    to_text(fastest), key, value));
}

bool is_whole(double count) { return std::abs(count - std::round(count)) < 1e-6 * count; }

/// The spacing nearest to `dx` that divides width and length; one of two digits if there is one
/// near. Nothing where none is near.
std::optional<double> dividing_spacing(double width, double length, double dx) {
    constexpr int far = 10'000;  // sites; with so many, one that divides is near if there is one
    std::optional<double> best;
    double best_distance = 1e300;
    const int middle = static_cast<int>(std::min(width / dx, 1e9));
    const int last = std::min(middle * 4 / 3 + 1, middle + far);
    for (int n = std::max({6, middle * 3 / 4, middle - far}); n <= last; ++n) {
        const double spacing = width / n;
        if (!is_whole(length / spacing)) continue;
        const bool short_number =
            std::abs(std::stod(fmt::format("{:.1e}", spacing)) / spacing - 1.0) < 1e-9;
        const double distance = std::abs(std::log(spacing / dx)) + (short_number ? 0.0 : 0.5);
        if (distance >= best_distance) continue;
        best = spacing;
        best_distance = distance;
    }
    return best;
}

/// What to write for a spacing near `dx`.
std::string fitting_spacing(const Case& c, double dx) {
    const auto spacing = dividing_spacing(c.domain.width.si, c.domain.length.si, dx);
    return spacing ? fmt::format("write dx = \"{}\"", rounded_text(Length{*spacing}, 9))
                   : "change the length of the box";
}

void judge_grid(Judge& judge, const Case& c) {
    if (!c.numerics.dx) return;
    const double dx = c.numerics.dx->si;
    const double width = c.domain.width.si, length = c.domain.length.si;
    const bool cells = !c.numerics.fluid_only;
    const double wanted = cells ? std::min(width / 12.0, c.cells.radius.si / 8.0) : width / 12.0;
    if (width / dx < 6.0)
        return judge.tell(
            {"numerics.dx"},
            fmt::format(
                "dx = {} leaves {:.1f} sites across the width, {}; at least 6 are needed; {}",
                to_text(*c.numerics.dx), width / dx, to_text(c.domain.width),
                fitting_spacing(c, wanted)));
    if (length / dx * (width / dx) > 1e9)
        return judge.tell(
            {"numerics.dx"},
            fmt::format("dx = {} makes {:.3g} sites; at most 1e9 are possible; {}",
                        to_text(*c.numerics.dx), length / dx * (width / dx),
                        fitting_spacing(c, std::max(wanted, std::sqrt(width * length / 1e6)))));
    if (cells && c.cells.radius.si / dx < 4.0)
        return judge.tell(
            {"numerics.dx"},
            fmt::format("dx = {} leaves {:.1f} sites to the radius of a cell; at least 4 are "
                        "needed; {}",
                        to_text(*c.numerics.dx), c.cells.radius.si / dx,
                        fitting_spacing(c, wanted)));
    if (is_whole(width / dx) && is_whole(length / dx)) return;
    judge.tell(
        {"numerics.dx"},
        fmt::format("dx = {} does not divide width = {} and length = {} into whole sites; {}",
                    to_text(*c.numerics.dx), to_text(c.domain.width), to_text(c.domain.length),
                    fitting_spacing(c, dx)));
}

void judge_times(Judge& judge, const Case& c) {
    const Time end = c.time.end;
    const auto check = [&](const std::optional<Time>& t, std::string_view path) {
        if (t && *t > end)
            judge.tell({path}, fmt::format("{} = {} is beyond the end of the run, {}; leave it out",
                                           Judge::key(path), to_text(*t), to_text(end)));
    };
    check(c.time.average_from, "time.average_from");
    // Intervals longer than the run are no fault: a run shortened by --set keeps its first and
    // last.
    check(c.numerics.dt, "numerics.dt");
    for (const Time t : c.output.figure_times) check(t, "output.figure_times");
}

}  // namespace

std::vector<Fault> find_conflicts(const Case& c, const Places& places, const std::string& file) {
    Judge judge(places, file);
    judge_exclusive(judge);
    judge_flow(judge, c);
    judge_cells(judge, c);
    judge_numerics(judge);
    return std::move(judge.faults);
}

std::vector<Fault> find_impossibilities(const Case& c, const Places& places,
                                        const std::string& file) {
    Judge judge(places, file);
    const bool cells_have_size = c.numerics.fluid_only || judge_outline(judge, c);
    if (cells_have_size && !c.numerics.fluid_only) {
        judge_fit(judge, c);
        judge_positions(judge, c);
    }
    if (c.layer.thickness && *c.layer.thickness >= c.domain.width)
        judge.tell(
            {"layer.thickness"},
            fmt::format("the layer is {} thick and the box {} wide; write thickness = \"{}\"",
                        to_text(*c.layer.thickness), to_text(c.domain.width),
                        rounded_text(Length{0.5 * c.domain.width.si})));
    judge_membrane(judge, c.membrane);
    judge_contact(judge, c.contact);
    judge_rate(judge, c);
    if (cells_have_size) judge_grid(judge, c);
    judge_times(judge, c);
    return std::move(judge.faults);
}

}  // namespace tt
