#include "app/run_request.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/option_values.hpp"
#include "case/kinds.hpp"
#include "case/resolve.hpp"

namespace tt {

RunRequest request_for(const Case& c, const Choice& choice, const Model& model) {
    RunRequest request;
    request.name = c.name;
    request.resolved_toml = resolved_toml(c, choice, model);
    request.inputs = inputs_of(c);
    request.settings = settings_of(c, choice);
    for (const Case& one : cases_by_kind(c)) {
        const CellOutline* outline = one.cells.outline();
        if (!outline || c.numerics.fluid_only) continue;
        request.notes.push_back("outline " + description(*outline));
        request.notes.insert(request.notes.end(), outline->remarks.begin(), outline->remarks.end());
    }
    if (const auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape)) {
        for (const auto& [label, text] : drawn->found) request.notes.push_back(label + ": " + text);
        request.notes.insert(request.notes.end(), drawn->remarks.begin(), drawn->remarks.end());
    }
    request.end = c.time.end;
    request.average_from = c.time.average_from.value_or(Time{0.5 * c.time.end.si});
    request.series = c.output.series;
    request.frames = c.output.frames;
    request.fields = c.output.fields;
    request.compress = c.output.compress;
    request.checkpoint = c.output.checkpoint;
    if (!c.numerics.fluid_only && choice.shear_rate.si != 0.0)
        for (const Case& one : cases_by_kind(c))
            request.shear_number = std::max(request.shear_number.value_or(0.0),
                                            shear_number_at(one, choice.shear_rate));
    return request;
}

namespace {

const std::vector<std::pair<std::string, ProgressMode>>& progress_modes() {
    static const std::vector<std::pair<std::string, ProgressMode>> modes{
        {"auto", ProgressMode::automatic},
        {"bar", ProgressMode::bar},
        {"log", ProgressMode::log},
        {"json", ProgressMode::json},
        {"none", ProgressMode::none}};
    return modes;
}

}  // namespace

void add_progress_option(CLI::App& verb, std::string& word) {
    std::vector<OptionWord> words;
    for (const auto& [name, mode] : progress_modes()) words.push_back({name, ""});
    add_choice(verb, "--progress", word, words)->each([](const std::string& chosen) {
        if (progress_mode(chosen) == ProgressMode::json) write_messages_as_json();
    });
}

ProgressMode progress_mode(const std::string& word) {
    return std::find_if(progress_modes().begin(), progress_modes().end(),
                        [&](const auto& mode) { return mode.first == word; })
        ->second;
}

}  // namespace tt
