#include "case/section_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/sections.hpp"
#include "case/table_names.hpp"
#include "case/walls_of.hpp"
#include "geometry/loops.hpp"

namespace tt {
namespace {

constexpr double slightest = 1e-4;  ///< slope that is none

std::string in_um(double length) { return fmt::format("{:.6g} um", 1e6 * length); }

/// `from = ["…", "…"], to = ["…", "…"]` of a line between these ends.
std::string cure(const SectionPlace& line, double begin, double end) {
    if (line.backwards) std::swap(begin, end);
    const std::string at = in_um(line.at);
    const auto point = [&](double along) {
        return line.upright ? fmt::format("[\"{}\", \"{}\"]", at, in_um(along))
                            : fmt::format("[\"{}\", \"{}\"]", in_um(along), at);
    };
    return fmt::format("from = {}, to = {}", point(begin), point(end));
}

/// "from 3 um to 12 um, from 20 um to 30 um" of so many.
std::string listed(const std::vector<OpenPiece>& pieces) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t n = 0; n < std::min(pieces.size(), most); ++n)
        text += fmt::format("{}from {} to {}", n == 0 ? "" : ", ", in_um(pieces[n].begin),
                            in_um(pieces[n].end));
    return text + (pieces.size() > most ? ", …" : "");
}

/// Lowest and highest corner of the box, in the coordinates of the drawing.
Corners box_of(const Case& c, const Solid& solid) {
    if (c.network()) return corners_of(solid.loops);
    return {{0.0, 0.0}, {c.domain.length.si, c.domain.width.si}};
}

/// The pieces with fluid of the whole line that a section lies on.
std::vector<OpenPiece> pieces_on(const Case& c, const Solid& solid, const Corners& box,
                                 const SectionPlace& line) {
    // In um: walls in one place cancel to a millionth of a unit.
    constexpr double unit = 1e-6;
    const double at = line.at - (line.upright ? box.low.x : box.low.y);
    const double aside = line.upright ? box.low.y : box.low.x;
    const bool walled = c.domain.sides == Sides::walls && !c.network();
    std::vector<OpenPiece> pieces =
        open_pieces(scaled(moved(solid, -box.low), 1.0 / unit), (box.high - box.low) / unit, walled,
                    line.upright, at / unit);
    for (OpenPiece& piece : pieces) piece = {unit * piece.begin + aside, unit * piece.end + aside};
    return pieces;
}

/// What is wrong with where it lies; empty if nothing is.
std::string fault_of(const Case& c, const Solid& solid, const SectionPlace& line) {
    const Corners box = box_of(c, solid);
    const char *across = line.upright ? "x" : "y", *along = line.upright ? "y" : "x";
    const double low = line.upright ? box.low.x : box.low.y;
    const double high = line.upright ? box.high.x : box.high.y;
    if (line.at <= low || line.at >= high)
        return fmt::format(
            "{} = {} is not inside of the box, which goes from {} to {}; write one "
            "that is",
            across, in_um(line.at), in_um(low), in_um(high));
    const std::vector<OpenPiece> all = pieces_on(c, solid, box, line);
    std::vector<OpenPiece> met, near;
    for (const OpenPiece& piece : all) {
        const double most = std::min(piece.end - piece.begin, line.end - line.begin);
        const double common = std::min(piece.end, line.end) - std::max(piece.begin, line.begin);
        if (common > 1e-3 * most) met.push_back(piece);
    }
    if (all.empty())
        return fmt::format("there is no fluid at {} = {}; write another {}", across, in_um(line.at),
                           across);
    if (met.empty())
        return fmt::format("it meets no fluid; at {} = {} there is some {}; write {}", across,
                           in_um(line.at), listed(all),
                           cure(line, all.front().begin, all.front().end));
    if (met.size() > 1)
        return fmt::format("it crosses {} channels, {}; a section crosses one: write {}",
                           met.size(), listed(met), cure(line, met.front().begin, met.front().end));
    const OpenPiece& piece = met.front();
    if (!std::isfinite(piece.begin) || !std::isfinite(piece.end))
        return fmt::format(
            "no wall ends the fluid along {}; a section goes from wall to wall "
            "across a channel",
            along);
    const double rounding = 1e-3 * (piece.end - piece.begin);
    if (line.begin > piece.begin + rounding || line.end < piece.end - rounding)
        return fmt::format("it ends within the fluid, which goes {}; write {}", listed({piece}),
                           cure(line, piece.begin, piece.end));
    return "";
}

/// Of a line that is along neither axis.
std::string oblique(Vec2 from, Vec2 to) {
    const Vec2 along = to - from;
    const bool upright = std::fabs(along.y) >= std::fabs(along.x);
    const Vec2 middle = 0.5 * (from + to);
    SectionPlace line;
    line.upright = upright;
    line.at = upright ? middle.x : middle.y;
    line.backwards = (upright ? along.y : along.x) < 0.0;
    const double reach = 0.5 * std::fabs(upright ? along.y : along.x);
    const double place = upright ? middle.y : middle.x;
    const double angle = std::atan2(along.y, along.x) * 180.0 / std::numbers::pi;
    return fmt::format(
        "it runs at {:.3g} deg; a section lies along x or y: write {}, which tells "
        "the same flow",
        angle, cure(line, place - reach, place + reach));
}

void judge_names(Judge& judge, const Case& c) {
    std::set<std::string> ports;
    for (const PortCase& port : c.ports) ports.insert(port.name);
    const auto look = [&](const char* table, const std::string& name) {
        const std::string path = fmt::format("{}.{}", table, name);
        if (!is_table_name(name)) judge.tell({path}, table_name_fault(table));
        if (ports.count(name) > 0)
            judge.tell({path}, fmt::format("'{}' is the name of a port, whose figures it would "
                                           "hide; write another name",
                                           name));
    };
    for (const SectionCase& section : c.sections) look("section", section.name);
    for (const ForkCase& fork : c.forks) look("fork", fork.name);
    for (const StretchCase& stretch : c.stretches) look("stretch", stretch.name);
}

/// The names that a fork or stretch asks for are those of sections, each another.
void judge_asked(Judge& judge, const Case& c, const std::string& path, const std::string& key,
                 const std::vector<std::string>& names) {
    const std::string at = path + "." + key;
    for (std::size_t n = 0; n < names.size(); ++n) {
        const auto same = [&](const SectionCase& s) { return s.name == names[n]; };
        if (std::none_of(c.sections.begin(), c.sections.end(), same))
            judge.tell({at, path},
                       c.sections.empty()
                           ? fmt::format("there is no section '{}'; write [section.{}] with from "
                                         "and to",
                                         names[n], names[n])
                           : fmt::format("there is no section '{}'; there are {}", names[n],
                                         listed_names(c.sections)));
        else if (std::count(names.begin(), names.begin() + static_cast<int>(n), names[n]) > 0)
            judge.tell({at, path},
                       fmt::format("'{}' is named twice; write another section", names[n]));
    }
}

void judge_fork(Judge& judge, const Case& c, const ForkCase& fork) {
    const std::string path = "fork." + fork.name;
    if (fork.parent.empty())
        judge.tell({path},
                   "parent is missing; write parent = \"NAME\", the section before the "
                   "fork");
    if (fork.daughters.size() != 2)
        judge.tell({path + ".daughters", path},
                   "a fork has two daughters; write daughters = [\"NAME\", \"NAME\"], the sections "
                   "behind it");
    std::vector<std::string> all = fork.daughters;
    judge_asked(judge, c, path, "daughters", all);
    if (fork.parent.empty()) return;
    judge_asked(judge, c, path, "parent", {fork.parent});
    if (std::count(all.begin(), all.end(), fork.parent) > 0)
        judge.tell({path + ".parent"},
                   fmt::format("'{}' is parent and daughter; write another section", fork.parent));
}

void judge_stretch(Judge& judge, const Case& c, const StretchCase& stretch) {
    const std::string path = "stretch." + stretch.name;
    if (stretch.from.empty() || stretch.to.empty())
        return judge.tell({path},
                          "a stretch lies between two sections; write from = \"NAME\" and "
                          "to = \"NAME\"");
    judge_asked(judge, c, path, "to", {stretch.from, stretch.to});
}

}  // namespace

std::optional<SectionPlace> place_of(const SectionCase& section) {
    if (section.from.size() != 2 || section.to.size() != 2) return std::nullopt;
    const Vec2 from{section.from[0].si, section.from[1].si};
    const Vec2 to{section.to[0].si, section.to[1].si}, along = to - from;
    const bool upright = std::fabs(along.x) <= slightest * std::fabs(along.y);
    if (along == Vec2{} || (!upright && std::fabs(along.y) > slightest * std::fabs(along.x)))
        return std::nullopt;
    const double a = upright ? from.y : from.x, b = upright ? to.y : to.x;
    return SectionPlace{upright, upright ? 0.5 * (from.x + to.x) : 0.5 * (from.y + to.y),
                        std::min(a, b), std::max(a, b), b < a};
}

void judge_section_keys(Judge& judge, const Case& c) {
    judge_names(judge, c);
    for (const SectionCase& section : c.sections) {
        const std::string path = "section." + section.name;
        for (const auto& [key, point] :
             {std::pair{"from", &section.from}, std::pair{"to", &section.to}})
            if (point->size() != 2)
                judge.tell({fmt::format("{}.{}", path, key), path},
                           fmt::format("{} is an end of the section; write {} = [\"40 um\", \"0 "
                                       "um\"]",
                                       key, key));
    }
    for (const ForkCase& fork : c.forks) {
        if (c.geometry.straight())
            judge.tell({"fork." + fork.name},
                       "a straight channel does not fork; write a shape in [geometry] that does, "
                       "or leave it out");
        judge_fork(judge, c, fork);
    }
    for (const StretchCase& stretch : c.stretches) judge_stretch(judge, c, stretch);
}

void judge_section_places(Judge& judge, const Case& c) {
    if (c.sections.empty()) return;
    const auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape);
    if ((drawn || c.network()) && c.geometry.channels().empty()) return;
    const Solid solid = solid_of(c);
    for (const SectionCase& section : c.sections) {
        if (section.from.size() != 2 || section.to.size() != 2) continue;
        const Vec2 from{section.from[0].si, section.from[1].si};
        const Vec2 to{section.to[0].si, section.to[1].si};
        const auto line = place_of(section);
        const std::string why = from == to ? "it has no length: from and to are one point; write "
                                             "the walls on both sides of the channel"
                                : !line    ? oblique(from, to)
                                           : fault_of(c, solid, *line);
        const std::string path = "section." + section.name;
        if (!why.empty())
            judge.tell({path + ".from", path}, fmt::format("section '{}': {}", section.name, why));
    }
}

}  // namespace tt
