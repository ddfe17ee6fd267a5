#include "observe/section_series.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "base/units.hpp"
#include "observe/section_measures.hpp"

namespace tt {
namespace {

std::string titles_of(const std::string& name) {
    const std::string flow = si_unit(KinematicViscosity::dimension);
    const std::string length = si_unit(Length::dimension), area = si_unit(Area::dimension);
    std::string text;
    const auto add = [&](const char* quantity, const std::string& unit) {
        text += fmt::format(",{}.{}", name, quantity);
        if (!unit.empty()) text += fmt::format(" [{}]", unit);
    };
    add("flow_rate", flow);
    add("mean_velocity", si_unit(Velocity::dimension));
    add("pressure", si_unit(Pressure::dimension));
    add("hematocrit_tube", "");
    add("hematocrit_discharge", "");
    add("cfl_from", length);
    add("cfl_to", length);
    add("cells_forward", "");
    add("cells_backward", "");
    add("cell_area", area);
    add("volume", area);
    return text;
}

}  // namespace

double relative_viscosity(const Model& model, const State& state, const Stretch& stretch) {
    const auto from = static_cast<std::size_t>(stretch.from);
    const auto to = static_cast<std::size_t>(stretch.to);
    // Both sections carry the same; where they were drawn the other way round, with another sign.
    const double near = flow_rate_at(model, state, from), far = flow_rate_at(model, state, to);
    const double flow = 0.5 * (near + std::copysign(far, near));
    const double drop = pressure_at(model, state, from) - pressure_at(model, state, to);
    if (flow == 0.0) return undefined;
    return drop / flow / (stretch.resistance * model.viscosity.plasma);
}

SectionSeries::SectionSeries(const Schedule& schedule, const std::filesystem::path& directory,
                             const Model& model)
    : Observer(schedule),
      model_(model),
      table_(directory, "sections"),
      last_area_(model.sections.size(), undefined),
      last_volume_(last_area_) {}

void SectionSeries::start() {
    std::string header = "time [s],step";
    for (const Section& section : model_.sections) header += titles_of(section.name);
    for (const Stretch& stretch : model_.stretches)
        header += fmt::format(",{0}.mu_rel,{0}.mu_app [{1}]", stretch.name,
                              si_unit(Viscosity::dimension));
    table_.start(header + '\n');
}

void SectionSeries::resume(const ArchiveReader& archive) {
    table_.resume(archive);
    last_area_ = archive.take<double>("sections.last_area");
    last_volume_ = archive.take<double>("sections.last_volume");
    for (auto* last : {&last_area_, &last_volume_}) last->resize(model_.sections.size(), undefined);
}

void SectionSeries::add_section(const Snapshot& snapshot, std::size_t n, std::string& row) {
    const State& state = snapshot.state();
    const Scales& scales = model_.scales;
    const Section& section = model_.sections[n];
    const SectionState& passed = state.sections[n];
    const SectionCells cells = cells_on_section(section.line, model_.lattice, state.cells);
    const double flow = flow_rate_at(model_, state, n), area = carried_area(model_, state, n);
    const double gone = passed.volume - last_volume_[n];
    // A volume of rounding carries nothing.
    const bool flows = std::fabs(gone) > 1e-9 * section.line.width();
    const double discharge = flows ? (area - last_area_[n]) / gone : undefined;
    last_area_[n] = area;
    last_volume_[n] = passed.volume;
    const bool turned = section.drawn_backwards;
    const auto put = [&](auto value) { fmt::format_to(std::back_inserter(row), ",{}", value); };
    put(scales.to_si<KinematicViscosity>(flow).si);
    put(scales.to_si<Velocity>(flow / section.line.width()).si);
    put(scales.to_si<Pressure>(pressure_at(model_, state, n)).si);
    put(cells.share);
    put(discharge);
    put(scales.to_si<Length>(turned ? cells.from_end : cells.from_begin).si);
    put(scales.to_si<Length>(turned ? cells.from_begin : cells.from_end).si);
    put(passed.forward);
    put(passed.backward);
    put(scales.to_si<Area>(area).si);
    put(scales.to_si<Area>(passed.volume).si);
}

void SectionSeries::observe(const Snapshot& snapshot) {
    std::string row = fmt::format("{},{}", snapshot.time().si, snapshot.step());
    for (std::size_t n = 0; n < model_.sections.size(); ++n) add_section(snapshot, n, row);
    for (const Stretch& stretch : model_.stretches) {
        const double ratio = relative_viscosity(model_, snapshot.state(), stretch);
        const double plasma = model_.scales.to_si<Viscosity>(model_.viscosity.plasma).si;
        fmt::format_to(std::back_inserter(row), ",{},{}", ratio, ratio * plasma);
    }
    table_.append(row + '\n');
}

void SectionSeries::save(ArchiveOutput& archive) const {
    table_.save(archive);
    archive.put("sections.last_area", last_area_);
    archive.put("sections.last_volume", last_volume_);
}

}  // namespace tt
