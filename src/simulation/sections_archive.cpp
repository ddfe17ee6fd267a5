#include "simulation/sections_archive.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "simulation/sound_state.hpp"

namespace tt {
namespace {

/// Calls visit(number) for each that is not whole: the one order of save, load and hash.
template <class S, class Visit>
void for_each_real(S& section, Visit&& visit) {
    for (auto* pair : {&section.inflow, &section.density})
        for (auto& number : *pair) visit(number);
    visit(section.volume);
    visit(section.area);
    for (auto& velocity : section.velocity)
        for (auto& number : velocity) visit(number);
}

std::vector<double> reals_of(const State& state) {
    std::vector<double> numbers;
    for (const SectionState& section : state.sections)
        for_each_real(section, [&](double number) { numbers.push_back(number); });
    return numbers;
}

/// Forward, backward and the number of sides of each section, then the sides.
std::vector<std::int64_t> whole_numbers_of(const State& state) {
    std::vector<std::int64_t> numbers;
    for (const SectionState& s : state.sections)
        for (const std::int64_t number :
             {s.forward, s.backward, static_cast<std::int64_t>(s.side.size())})
            numbers.push_back(number);
    for (const SectionState& s : state.sections)
        numbers.insert(numbers.end(), s.side.begin(), s.side.end());
    return numbers;
}

}  // namespace

void save_sections(ArchiveOutput& archive, const State& state) {
    if (state.sections.empty()) return;
    archive.put("sections", reals_of(state));
    archive.put("sections.counts", whole_numbers_of(state));
}

void load_sections(const ArchiveReader& archive, const Model& model, State& state) {
    state.sections.resize(model.sections.size());
    if (state.sections.empty()) return;
    const auto reals = archive.take<double>("sections");
    const auto counts = archive.take<std::int64_t>("sections.counts");
    // Before the first step no velocity has been read.
    const bool read = state.step > 0;
    for (std::size_t n = 0; n < state.sections.size(); ++n)
        for (auto& velocity : state.sections[n].velocity)
            velocity.resize(read ? model.sections[n].line.rows.size() : 0);
    if (reals.size() != reals_of(state).size() || counts.size() < 3 * state.sections.size())
        refuse_checkpoint("it is of other sections");
    const double* real = reals.data();
    const std::int64_t* count = counts.data();
    std::size_t sides = counts.size() - 3 * state.sections.size();
    const std::size_t cells =
        static_cast<std::size_t>(state.cells.cell_count()) + state.departed.size();
    for (SectionState& s : state.sections) {
        for_each_real(s, [&](double& number) { number = *real++; });
        s.forward = *count++;
        s.backward = *count++;
        const std::int64_t known = *count++;
        if (s.forward < 0 || s.backward < 0 || known < 0 ||
            static_cast<std::size_t>(known) > std::min(sides, cells))
            refuse_checkpoint("its counts of cells at sections are wrong");
        sides -= static_cast<std::size_t>(known);
        s.side.resize(static_cast<std::size_t>(known));
    }
    if (sides != 0) refuse_checkpoint("its counts of cells at sections are wrong");
    for (SectionState& s : state.sections)
        for (std::int8_t& side : s.side) {
            if (*count < -1 || *count > 1) refuse_checkpoint("a cell is on no side of a section");
            side = static_cast<std::int8_t>(*count++);
        }
    for (const double number : reals)
        if (!std::isfinite(number))
            refuse_checkpoint("'sections' holds a number that is not finite");
}

void hash_sections(const State& state, Checksum& sum) {
    const std::vector<double> reals = reals_of(state);
    const std::vector<std::int64_t> counts = whole_numbers_of(state);
    sum.add(reals.data(), reals.size() * sizeof(double));
    sum.add(counts.data(), counts.size() * sizeof(std::int64_t));
}

}  // namespace tt
