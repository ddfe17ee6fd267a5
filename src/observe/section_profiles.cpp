#include "observe/section_profiles.hpp"

#include <utility>
#include <vector>

#include "io/csv.hpp"
#include "observe/section_measures.hpp"

namespace tt {
namespace {

std::size_t numbers_of(const Model& model) {
    std::size_t numbers = 0;
    for (const Section& section : model.sections) numbers += 2 * section.line.rows.size();
    return numbers;
}

}  // namespace

SectionProfiles::SectionProfiles(const Schedule& schedule, const std::filesystem::path& directory,
                                 Time from, const Model& model,
                                 std::function<void(const std::string&)> say)
    : Observer(schedule),
      model_(model),
      average_(directory, "section_profiles", "section_profiles.csv", from, numbers_of(model),
               std::move(say)) {}

void SectionProfiles::observe(const Snapshot& snapshot) {
    const State& state = snapshot.state();
    const double speed = model_.scales.unit(Velocity::dimension);
    std::vector<double> look;
    for (std::size_t n = 0; n < model_.sections.size(); ++n) {
        const SectionLine& line = model_.sections[n].line;
        const auto& [now, before] = state.sections[n].velocity;
        for (std::size_t k = 0; k < line.rows.size(); ++k)  // none before the first step
            look.push_back(k < now.size() ? 0.5 * speed * (now[k] + before[k]) : 0.0);
        const SectionCells cells = cells_on_section(line, model_.lattice, state.cells);
        look.insert(look.end(), cells.share_of_row.begin(), cells.share_of_row.end());
    }
    average_.look(snapshot.time(), look);
}

std::string SectionProfiles::table() const {
    std::string text = csv_header<SectionProfileRow>();
    std::size_t first = 0;
    for (std::size_t n = 0; n < model_.sections.size(); ++n) {
        const SectionLine& line = model_.sections[n].line;
        const std::size_t rows = line.rows.size();
        for (std::size_t k = 0; k < rows; ++k) {
            const bool turned = model_.sections[n].drawn_backwards;
            const std::size_t row = turned ? rows - 1 - k : k;
            const double along = line.rows[row] + 0.5;
            const double place = turned ? line.end - along : along - line.begin;
            text += csv_row(
                SectionProfileRow{static_cast<std::int64_t>(n), model_.scales.to_si<Length>(place),
                                  Velocity{average_.mean(first + row)},
                                  average_.mean(first + rows + row), average_.samples()});
        }
        first += 2 * rows;
    }
    return text;
}

}  // namespace tt
