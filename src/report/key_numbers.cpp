#include "report/key_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "report/html.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

/// Of the circle that has the area of the first cell at the start.
double equivalent_radius(const Results& run) {
    const std::vector<double>& areas = values(run.cells, "area");
    return areas.empty() ? undefined : std::sqrt(areas.front() / std::numbers::pi);
}

double summary_value(const Results& run, const char* name) {
    const auto found = run.summary.find(name);
    return found == run.summary.end() || !found->is_object()
               ? undefined
               : number_of(*found, "value", undefined);
}

/// What `auto` chose for a key, of PROVENANCE.json.
double chosen(const Results& run, const std::string& key) {
    const auto settings = run.provenance.find("settings");
    if (settings == run.provenance.end() || !settings->is_array()) return undefined;
    const std::string start = "chosen." + key + " = ";
    for (const Json& line : *settings)
        if (line.is_string() && line.get<std::string>().starts_with(start))
            return std::strtod(line.get<std::string>().c_str() + start.size(), nullptr);
    return undefined;
}

double shear_rate(const Results& run, double radius) {
    if (run.setting("flow.drive") != "shear")
        return std::abs(window_mean(run, "pseudo_shear_rate"));
    const double rate = std::abs(setting_si(run.setting("flow.shear_rate")));
    if (std::isfinite(rate)) return rate;
    const double number = std::abs(setting_si(run.setting("flow.shear_number")));
    return number * setting_si(run.setting("membrane.shear_modulus")) /
           (setting_si(run.setting("plasma.viscosity")) * radius);
}

struct Row {
    const char *name, *unit, *meaning;
    double KeyNumbers::*value;
};

constexpr Row key_rows[] = {
    {"shear number G", "", "μ k a / E_s (Eq. 19), of the flow as it was asked for",
     &KeyNumbers::shear_number},
    {"Reynolds number of a cell", "", "ρ k a² / μ, of the flow as it was",
     &KeyNumbers::cell_reynolds},
    {"the same, as computed", "", "times the density scale, by which longer steps are bought",
     &KeyNumbers::cell_reynolds_run},
    {"Reynolds number of the channel", "", "ρ U H / μ, of the flow as it was",
     &KeyNumbers::channel_reynolds},
    {"shear rate k", "1/s", "of the walls in shear; in a channel mean velocity / width",
     &KeyNumbers::shear_rate},
    {"wall shear stress", "Pa", "from the velocity gradient at both walls",
     &KeyNumbers::wall_shear_stress},
    {"mean velocity U", "m/s", "along the channel", &KeyNumbers::mean_velocity},
    {"hematocrit", "", "area of the cells / area of the box", &KeyNumbers::hematocrit},
};

}  // namespace

KeyNumbers key_numbers(const Results& run) {
    const bool shear = run.setting("flow.drive") == "shear";
    const double density = setting_si(run.setting("plasma.density"));
    const double viscosity = setting_si(run.setting("plasma.viscosity"));
    const double radius = equivalent_radius(run);
    KeyNumbers n;
    n.shear_rate = shear_rate(run, radius);
    n.shear_number = summary_value(run, "shear_number");
    n.cell_reynolds = density * n.shear_rate * radius * radius / viscosity;
    n.cell_reynolds_run = chosen(run, "density_scale") * n.cell_reynolds;
    n.wall_shear_stress = window_mean(run, "wall_shear_stress");
    n.mean_velocity = shear ? undefined : window_mean(run, "mean_velocity");
    n.channel_reynolds =
        density * std::abs(n.mean_velocity) * setting_si(run.setting("domain.width")) / viscosity;
    n.hematocrit = window_mean(run, "hematocrit_tube");
    return n;
}

std::string key_numbers_section(std::span<const Results> runs,
                                const std::vector<std::string>& labels) {
    std::vector<KeyNumbers> all;
    for (const Results& run : runs) all.push_back(key_numbers(run));
    std::vector<HtmlTable::Column> columns{{"number", ""}};
    for (const std::string& label : labels)
        columns.push_back({runs.size() == 1 ? "value" : label, "number"});
    columns.push_back({"unit", "unit"});
    columns.push_back({"meaning", "meaning"});
    HtmlTable table("Means over the window of the summary, or the later half of the run.", columns);
    bool any = false;
    for (const Row& row : key_rows) {
        const DisplayUnit unit = display_unit(row.unit);
        const auto told = [&](const KeyNumbers& n) { return std::isfinite(n.*row.value); };
        if (std::none_of(all.begin(), all.end(), told)) continue;
        any = true;
        std::vector<std::string> texts{row.name};
        for (const KeyNumbers& n : all) texts.push_back(number_text(n.*row.value * unit.factor, 3));
        texts.push_back(unit.name);
        texts.emplace_back(row.meaning);
        table.add_row(texts);
    }
    return any ? heading("numbers", "Key numbers") + table.text() : "";
}

}  // namespace tt
