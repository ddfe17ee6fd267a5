#include "report/page_tables.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "report/html.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

/// Mean ± standard error, where that is known.
std::string mean_text(const SummaryLine& line) {
    const double factor = display_unit(line.unit).factor;
    return with_scatter(line.mean * factor, line.standard_error * factor);
}

std::string window_text(const Results& run) {
    if (run.window_end <= run.window_begin) return "";
    return fmt::format("{} to {} ms", number_text(run.window_begin * 1e3),
                       number_text(run.window_end * 1e3));
}

const SummaryLine* find(const Results& run, const std::string& name) {
    for (const SummaryLine& line : run.quantities)
        if (line.name == name) return &line;
    return nullptr;
}

std::string summary_of_one(const Results& run) {
    HtmlTable table("Means over " + window_text(run) +
                        " ± their standard error by batch means; the standard deviation over "
                        "time, and that over cells of each cell's mean.",
                    {{"quantity", ""},
                     {"unit", "unit"},
                     {"mean ± error", "number"},
                     {"sd in time", "number"},
                     {"sd over cells", "number"},
                     {"meaning", "meaning"}});
    for (const SummaryLine& line : run.quantities) {
        const DisplayUnit unit = display_unit(line.unit);
        std::string meaning = meaning_of_quantity(line.name);
        if (!line.reason.empty()) meaning += ". Not defined: " + line.reason;
        table.add_row({line.name, unit.name, mean_text(line),
                       number_text(line.sd_time * unit.factor, 2),
                       number_text(line.sd_cells * unit.factor, 2), meaning});
    }
    return table.text();
}

/// Names of the quantities of all runs, each once, in the order in which they come.
std::vector<SummaryLine> all_quantities(std::span<const Results> runs) {
    std::set<std::string> known;
    std::vector<SummaryLine> lines;
    for (const Results& run : runs)
        for (const SummaryLine& line : run.quantities)
            if (known.insert(line.name).second) lines.push_back(line);
    return lines;
}

std::string summary_of_many(std::span<const Results> runs, const std::vector<std::string>& labels) {
    std::vector<HtmlTable::Column> columns{{"quantity", ""}, {"unit", "unit"}};
    for (const std::string& label : labels) columns.push_back({label, "number"});
    HtmlTable table("Means over each run's window ± their standard error by batch means.", columns);

    std::vector<std::string> windows{"window", ""};
    for (const Results& run : runs) windows.push_back(window_text(run));
    table.add_row(windows);
    for (const SummaryLine& quantity : all_quantities(runs)) {
        std::vector<std::string> texts{quantity.name, display_unit(quantity.unit).name};
        for (const Results& run : runs) {
            const SummaryLine* line = find(run, quantity.name);
            texts.push_back(line ? mean_text(*line) : "–");
        }
        table.add_row(texts);
    }
    return table.text();
}

/// Keys of the settings of all runs but their names, each once.
std::set<std::string> all_settings(std::span<const Results> runs) {
    std::set<std::string> keys;
    for (const Results& run : runs)
        for (const auto& [key, value] : run.settings)
            if (key != "name") keys.insert(key);
    return keys;
}

std::string verdict(const RunCheck& check) {
    if (check.verdict == RunCheck::Verdict::ok) return "ok";
    return check.verdict == RunCheck::Verdict::failed ? "FAILED" : "warning";
}

std::string value_text(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Nested objects become rows too, `outer inner` for a name; items of a list are numbered.
void add_rows(const Json& json, const std::string& prefix, HtmlTable& table) {
    for (const auto& [key, value] : json.items()) {
        if (value.is_structured() && !value.empty())
            add_rows(value, prefix + key + " ", table);
        else
            table.add_row({prefix + key, value_text(value)});
    }
}

}  // namespace

std::string summary_section(std::span<const Results> runs, const std::vector<std::string>& labels) {
    const std::string title = heading("summary", "Summary");
    if (all_quantities(runs).empty())
        return title + "<p>No summary yet: it is written when a run ends.</p>\n";
    return title +
           (runs.size() == 1 ? summary_of_one(runs.front()) : summary_of_many(runs, labels));
}

std::string differences_section(std::span<const Results> runs,
                                const std::vector<std::string>& labels) {
    std::vector<std::string> keys;
    for (const std::string& key : all_settings(runs)) {
        const auto same = [&](const Results& run) {
            return run.setting(key) == runs.front().setting(key);
        };
        if (!std::all_of(runs.begin(), runs.end(), same)) keys.push_back(key);
    }
    if (keys.empty()) return "<p>All runs have the same settings.</p>\n";
    std::vector<HtmlTable::Column> columns{{"run", ""}};
    for (const std::string& key : keys) columns.push_back({key, "number"});
    HtmlTable table("Settings that differ.", columns);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        std::vector<std::string> texts{labels[r]};
        for (const std::string& key : keys) texts.push_back(runs[r].setting(key, "–"));
        table.add_row(texts);
    }
    return table.text();
}

std::string checks_section(std::span<const Results> runs, const std::vector<std::string>& labels) {
    const bool single = runs.size() == 1;
    std::vector<HtmlTable::Column> columns{
        {"check", ""}, {"verdict", ""}, {"what was found", "meaning"}};
    if (!single) columns.insert(columns.begin(), {"run", ""});
    HtmlTable table(single ? "" : "What is not in order.", columns);
    std::size_t told = 0, all = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        for (const RunCheck& check : runs[r].checks) {
            const bool ok = check.verdict == RunCheck::Verdict::ok;
            ++all;
            if (!single && ok) continue;
            ++told;
            std::vector<std::string> texts{check.name, verdict(check), check.sentence};
            if (!single) texts.insert(texts.begin(), labels[r]);
            table.add_row(texts, ok ? "" : "raised");
        }
    }
    std::string text = heading("checks", "Checks");
    if (all == 0) return text + "<p>Nothing to judge yet.</p>\n";
    if (told > 0) text += table.text();
    if (!single) text += fmt::format("<p>{} of {} checks are in order.</p>\n", all - told, all);
    return text;
}

std::string provenance_section(std::span<const Results> runs,
                               const std::vector<std::string>& labels) {
    std::string text = heading("provenance", "Provenance");
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs[r].provenance.empty()) continue;
        HtmlTable table("", {{"what", ""}, {"value", "word"}});
        add_rows(runs[r].provenance, "", table);
        text += fmt::format("<details><summary>{}</summary>{}</details>\n", html(labels[r]),
                            table.text());
    }
    return text;
}

}  // namespace tt
