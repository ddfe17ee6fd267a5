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
#include "case/choose.hpp"
#include "case/contact_at_start.hpp"
#include "case/fit.hpp"
#include "case/judge.hpp"
#include "case/judge_channels.hpp"
#include "case/judge_flow.hpp"
#include "case/kinds.hpp"
#include "case/openings.hpp"
#include "case/sections.hpp"
#include "case/membrane_of.hpp"
#include "case/step_limits.hpp"
#include "case/value_text.hpp"

namespace tt {
namespace {

/// Whether the outline of a file has the size of a cell. In another unit than it is read in it is
/// far too large, and would be made of any number of nodes, or far too small.
bool judge_outline(Judge& judge, const Case& c) {
    if (!c.cells.outline()) return true;
    const OutlineMeasures m = measures_of(*c.cells.outline());
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
    if (is_drop(membrane) && !membrane.hardening.apply_to.empty())
        judge.tell({"membrane.law"},
                   fmt::format("a drop of constant surface tension has no membrane that hardens: "
                               "in [{}] write apply_to = []",
                               judge.table("membrane.hardening")));
}

/// What a body that keeps its shape cannot have.
void judge_rigid(Judge& judge, const Case& c, bool first) {
    if (!c.membrane.rigid) return;
    if (c.cells.initial_stretch.value_or(1.0) != 1.0)
        judge.tell({"cells.initial_stretch"},
                   "a rigid body cannot start stretched; write initial_stretch = 1");
    const ShearDrive* shear = c.flow.shear();
    if (first && shear && shear->shear_number)
        judge.tell({"flow.shear_number"},
                   "shear_number is built on the membrane of the first kind, and a rigid body has "
                   "none; write shear_rate");
}

void judge_contact(Judge& judge, const MorseContact& contact) {
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

/// Longer than a cell it would push each cell by its own image.
void judge_repulsion(Judge& judge, const Case& c) {
    const auto& range = c.contact.repulsion_range;
    const Length radius = smallest_cell_radius(c);
    if (!repels(c) || !range || *range <= radius) return;
    judge.tell(
        {"contact.repulsion_range"},
        fmt::format("repulsion_range = {} is more than the radius of a cell, {}; write "
                    "repulsion_range = \"{}\"",
                    to_text(*range), to_text(radius), rounded_text(Length{0.05 * radius.si}, 2)));
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

/// What to write where there are too many sites: a coarser grid, about `wanted` and of a million
/// sites where that resolves the box and its cells, else a shorter box.
std::string fewer_sites(const Case& c, double wanted) {
    const double width = c.domain.width.si, length = c.domain.length.si;
    const double dx = std::clamp(std::sqrt(width * length / 1e6), wanted, 1.4 * wanted);
    if (width * length / (dx * dx) < most_sites) return fitting_spacing(c, dx);
    constexpr double fewest = 100.0;  // along the side that is made shorter
    const double sites =
        std::max(std::floor(0.1 * most_sites / (std::min(width, length) / dx)), fewest);
    return fmt::format("write {} = \"{}\"", width > length ? "width" : "length",
                       rounded_text(Length{sites * dx}, 9));
}

void judge_grid(Judge& judge, const Case& c) {
    if (!c.numerics.dx) return;
    const double dx = c.numerics.dx->si;
    const double width = c.domain.width.si, length = c.domain.length.si;
    const bool cells = !c.numerics.fluid_only;
    double radius = HUGE_VAL;
    for (const Case& one : cases_by_kind(c)) radius = std::min(radius, one.cells.radius.si);
    const double wanted = cells ? std::min(width / 12.0, radius / 8.0) : width / 12.0;
    if (width / dx < 6.0)
        return judge.tell(
            {"numerics.dx"},
            fmt::format(
                "dx = {} leaves {:.1f} sites across the width, {}; at least 6 are needed; {}",
                to_text(*c.numerics.dx), width / dx, to_text(c.domain.width),
                fitting_spacing(c, wanted)));
    if (length / dx * (width / dx) > most_sites)
        return judge.tell({"numerics.dx"},
                          fmt::format("dx = {} makes {} sites; at most {} are possible; {}",
                                      to_text(*c.numerics.dx),
                                      rounded_text(length / dx * (width / dx), Dimension{}, 3),
                                      to_text(most_sites), fewer_sites(c, wanted)));
    if (cells && radius / dx < 4.0)
        return judge.tell(
            {"numerics.dx"},
            fmt::format("dx = {} leaves {:.1f} sites to the radius of a cell; at least 4 are "
                        "needed; {}",
                        to_text(*c.numerics.dx), radius / dx, fitting_spacing(c, wanted)));
    if (c.network() || (is_whole(width / dx) && is_whole(length / dx))) return;
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
    if (c.time.average_from == end)
        judge.tell({"time.average_from"},
                   fmt::format("average_from = {} is the end of the run, and nothing is left to "
                               "average; leave it out",
                               to_text(end)));
    // Intervals longer than the run are no fault: a run shortened by --set keeps its first and
    // last.
    check(c.numerics.dt, "numerics.dt");
    for (const Time t : c.output.figure_times) check(t, "output.figure_times");
}

/// What of each kind cannot be. Returns whether all have the size of a cell.
bool judge_kinds(Judge& judge, const Case& c) {
    bool sized = true;
    const std::vector<Case> kinds = cases_by_kind(c);
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const Case& one = kinds[n];
        if (!c.kinds.empty()) judge.look_at_kind(c.kinds[n].name);
        judge_membrane(judge, one.membrane);
        judge_rigid(judge, one, n == 0);
        if (c.numerics.fluid_only) continue;
        if (judge_outline(judge, one)) {
            judge_fit(judge, one);
            judge_positions(judge, one);
        } else {
            sized = false;
        }
    }
    judge.look_at_kind({});
    return sized;
}

}  // namespace

std::vector<Fault> find_impossibilities(const Case& c, const Places& places,
                                        const std::string& file) {
    Judge judge(places, file);
    const bool cells_have_size = judge_kinds(judge, c);
    if (c.layer.thickness && *c.layer.thickness >= c.domain.width)
        judge.tell(
            {"layer.thickness"},
            fmt::format("the layer is {} thick and the box {} wide; write thickness = \"{}\"",
                        to_text(*c.layer.thickness), to_text(c.domain.width),
                        rounded_text(Length{0.5 * c.domain.width.si})));
    judge_walls(judge, c);
    for (const auto& [name, why] : port_places(c).faults)
        judge.tell({"port." + name + ".at"}, fmt::format("port '{}': {}", name, why));
    judge_section_places(judge, c);
    if (c.contact.morse()) judge_contact(judge, *c.contact.morse());
    judge_flow(judge, c, cells_have_size && !c.numerics.fluid_only);
    if (cells_have_size && !c.numerics.fluid_only) judge_repulsion(judge, c);
    if (cells_have_size) judge_feeds(judge, c);
    if (cells_have_size) judge_grid(judge, c);
    judge_times(judge, c);
    return std::move(judge.faults);
}

}  // namespace tt
