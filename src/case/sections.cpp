#include "case/sections.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/section_place.hpp"
#include "case/walls_of.hpp"

namespace tt {
namespace {

int number_of(const std::vector<Section>& sections, const std::string& name) {
    const auto found = std::find_if(sections.begin(), sections.end(),
                                    [&](const Section& s) { return s.name == name; });
    return static_cast<int>(found - sections.begin());
}

[[noreturn]] void refuse(const std::string& table, const std::string& name, std::string why) {
    throw CaseError({{"", 0, 0, fmt::format("[{}.{}] {}", table, name, std::move(why))}});
}

/// What plasma alone carries through a section, whichever way.
double flow_of(const std::vector<Section>& sections, int n) {
    return std::fabs(sections[static_cast<std::size_t>(n)].plasma.inflow);
}

/// Flow rates that should be the same are, but for what walls between sites do to them.
constexpr double same_flow = 0.01;

}  // namespace

std::vector<Section> lattice_sections(const Case& c, const Choice& choice, const Walls* walls) {
    const Lattice lattice = lattice_of(c, choice);
    const double dx = choice.dx.si;
    std::vector<Section> sections;
    std::vector<Fault> faults;
    for (const SectionCase& given : c.sections) {
        const SectionPlace place = *place_of(given);
        const double origin = place.upright ? choice.origin.x : choice.origin.y;
        const double aside = place.upright ? choice.origin.y : choice.origin.x;
        const int most = (place.upright ? lattice.nx : lattice.ny) - 1;
        const int plane =
            std::clamp(static_cast<int>(std::lround((place.at - origin) / dx)), 1, most);
        const double middle = (0.5 * (place.begin + place.end) - aside) / dx;
        Section section;
        section.name = given.name;
        section.drawn_backwards = place.backwards;
        const Vec2 box{static_cast<double>(lattice.nx), static_cast<double>(lattice.ny)};
        for (const OpenPiece& piece :
             open_pieces(walls ? walls->solid : Solid{}, box, lattice.walls, place.upright, plane))
            if (piece.begin <= middle && middle <= piece.end)
                section.line =
                    section_line(lattice, walls, place.upright, plane, piece.begin, piece.end);
        section.line.sign = place.upright == !place.backwards ? 1 : -1;
        constexpr std::size_t fewest = 4;
        if (section.line.rows.size() < fewest)
            faults.push_back(
                {"", 0, 0,
                 fmt::format("[section.{}] it has {} sites with fluid on both sides, and takes {}; "
                             "keep two sites ({}) away from ports and ends, or write a smaller dx",
                             given.name, section.line.rows.size(), fewest,
                             rounded_text(Length{2.0 * dx}, 2))});
        sections.push_back(std::move(section));
    }
    if (!faults.empty()) throw CaseError(std::move(faults));
    return sections;
}

std::vector<Fork> forks_of(const Case& c, const std::vector<Section>& sections) {
    std::vector<Fork> forks;
    for (const ForkCase& given : c.forks) {
        Fork fork{given.name, number_of(sections, given.parent), {}};
        for (std::size_t n = 0; n < 2; ++n)
            fork.daughters[n] = number_of(sections, given.daughters[n]);
        const double parent = flow_of(sections, fork.parent);
        const double first = flow_of(sections, fork.daughters[0]);
        const double second = flow_of(sections, fork.daughters[1]);
        if (std::fabs(first + second - parent) > same_flow * (first + second + parent))
            refuse("fork", given.name,
                   fmt::format(
                       "plasma alone carries {:.3g} and {:.3g} times as much through '{}' and '{}' "
                       "as through '{}', and these should add up to 1: write as parent the "
                       "section before the fork, and as daughters those of the two channels "
                       "behind it",
                       first / parent, second / parent, given.daughters[0], given.daughters[1],
                       given.parent));
        forks.push_back(fork);
    }
    return forks;
}

std::vector<Stretch> stretches_of(const Case& c, const Choice& choice) {
    const std::vector<Section>& sections = choice.sections;
    std::vector<Stretch> stretches;
    for (const StretchCase& given : c.stretches) {
        Stretch stretch{given.name, number_of(sections, given.from), number_of(sections, given.to)};
        const auto& from = sections[static_cast<std::size_t>(stretch.from)];
        const auto& to = sections[static_cast<std::size_t>(stretch.to)];
        if (!choice.walls) {  // Poiseuille
            const double length = (to.line.plane - from.line.plane) * from.line.sign;
            stretch.resistance = 12.0 * length / std::pow(from.line.width(), 3);
            stretches.push_back(stretch);
            continue;
        }
        const double near = flow_of(sections, stretch.from), far = flow_of(sections, stretch.to);
        if (std::fabs(near - far) > same_flow * (near + far))
            refuse("stretch", given.name,
                   fmt::format("plasma alone carries {:.3g} times as much through '{}' as through "
                               "'{}': a channel branches off between them; name two sections of "
                               "one channel",
                               far / near, given.to, given.from));
        const double sampled =
            c.network() ? choice.walls->sampled_flow() : choice.undisturbed->site_mean;
        stretch.resistance = (from.plasma.density - to.plasma.density) * d2q9::sound_speed_squared *
                             sampled / from.plasma.inflow;
        stretches.push_back(stretch);
    }
    return stretches;
}

}  // namespace tt
