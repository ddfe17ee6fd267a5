#include "observe/places.hpp"

#include <utility>

#include "io/json.hpp"

namespace tt {
namespace {

Json ports_of(const Model& model) {
    Json ports = Json::array();
    const double dx = model.scales.length;
    for (std::size_t n = 0; n < model.port_names.size(); ++n) {
        const Opening& opening = model.boundaries.walls->solid.openings[n];
        const LatticeOpening& place = model.boundaries.walls->openings[n];
        const Vec2 from = dx * (opening.from + model.origin), to = dx * (opening.to + model.origin);
        ports.push_back({{"name", model.port_names[n]},
                         {"from", {from.x, from.y}},
                         {"to", {to.x, to.y}},
                         {"out", {place.out_x, place.out_y}}});
    }
    return ports;
}

Json section_of(const Model& model, const Section& section) {
    const double dx = model.scales.length;
    const SectionLine& line = section.line;
    Vec2 from = dx * (line.place(line.begin) + model.origin);
    Vec2 to = dx * (line.place(line.end) + model.origin);
    if (section.drawn_backwards) std::swap(from, to);
    const int sign = line.sign;
    return {{"name", section.name},
            {"from", {from.x, from.y}},
            {"to", {to.x, to.y}},
            {"width", dx * line.width()},
            {"forward", {line.upright ? sign : 0, line.upright ? 0 : sign}}};
}

}  // namespace

void write_places(const std::filesystem::path& results, const Model& model) {
    if (model.port_names.empty() && model.sections.empty()) return;
    Json places{{"ports", ports_of(model)},
                {"sections", Json::array()},
                {"forks", Json::array()},
                {"stretches", Json::array()}};
    for (const Section& section : model.sections)
        places["sections"].push_back(section_of(model, section));
    const auto name = [&](int n) { return model.sections[static_cast<std::size_t>(n)].name; };
    for (const Fork& fork : model.forks)
        places["forks"].push_back(
            {{"name", fork.name},
             {"parent", name(fork.parent)},
             {"daughters", {name(fork.daughters[0]), name(fork.daughters[1])}}});
    for (const Stretch& stretch : model.stretches)
        places["stretches"].push_back(
            {{"name", stretch.name}, {"from", name(stretch.from)}, {"to", name(stretch.to)}});
    write_json(results / "places.json", places, Durability::power);
}

}  // namespace tt
