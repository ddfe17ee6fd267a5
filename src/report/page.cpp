#include "report/page.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/version.hpp"
#include "io/file.hpp"
#include "observe/measures.hpp"
#include "report/assets.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

std::string meaning_of(const std::string& name) {
    std::string meaning;
    for_each_field<CellMeasures>([&](const auto& entry) {
        if (entry.key == name) meaning = entry.meaning;
    });
    for_each_field<RunMeasures>([&](const auto& entry) {
        if (entry.key == name) meaning = entry.meaning;
    });
    return meaning;
}

std::string mean_with_scatter(const SummaryLine& line) {
    const DisplayUnit unit = display_unit(line.unit);
    std::string text = number_text(line.mean * unit.factor);
    // A scatter at the level of rounding is none.
    const double sd = line.sd_time < 1e-12 * std::abs(line.mean) ? 0.0 : line.sd_time;
    if (std::isfinite(sd)) text += " ± " + number_text(sd * unit.factor, 2);
    return text;
}

const SummaryLine* find(const Results& run, const std::string& name) {
    for (const SummaryLine& line : run.quantities)
        if (line.name == name) return &line;
    return nullptr;
}

std::string window_text(const Results& run) {
    if (run.window_end <= run.window_begin) return "";
    return fmt::format("{} to {} ms", number_text(run.window_begin * 1e3),
                       number_text(run.window_end * 1e3));
}

/// One run: mean ± scatter over time, scatter over cells, unit, meaning.
std::string summary_of_one(const Results& run) {
    std::string text = fmt::format(
        "<div class=\"scroll\"><table><caption>Means over {} ± standard deviation over time; then "
        "the standard deviation over "
        "cells of each cell's mean.</caption>\n<thead><tr><th scope=\"col\">quantity</th><th "
        "scope=\"col\" class=\"number\">mean ± "
        "sd in time</th><th scope=\"col\" class=\"number\">sd over cells</th><th "
        "scope=\"col\">unit</th><th scope=\"col\">meaning"
        "</th></tr></thead>\n<tbody>\n",
        html(window_text(run)));
    for (const SummaryLine& line : run.quantities) {
        const DisplayUnit unit = display_unit(line.unit);
        text += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td "
            "class=\"number\">{}</td><td>{}</td>"
            "<td class=\"meaning\">{}</td></tr>\n",
            html(line.name), mean_with_scatter(line), number_text(line.sd_cells * unit.factor, 2),
            html(unit.name), html(meaning_of(line.name)));
    }
    return text + "</tbody></table></div>\n";
}

/// Several runs side by side.
std::string summary_of_many(std::span<const Results> runs, const std::vector<std::string>& labels) {
    std::string text =
        "<div class=\"scroll\"><table><caption>Means over each run's window ± standard deviation "
        "over time."
        "</caption>\n<thead><tr><th scope=\"col\">quantity</th><th scope=\"col\">unit</th>";
    for (const std::string& label : labels)
        text += "<th scope=\"col\" class=\"number\">" + html(label) + "</th>";
    text += "</tr></thead>\n<tbody>\n<tr><th scope=\"row\">window</th><td></td>";
    for (const Results& run : runs)
        text += "<td class=\"number\">" + html(window_text(run)) + "</td>";
    text += "</tr>\n";
    std::set<std::string> told;
    for (const Results& source : runs)
        for (const SummaryLine& named : source.quantities) {
            if (!told.insert(named.name).second) continue;
            text += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td>", html(named.name),
                                html(display_unit(named.unit).name));
            for (const Results& run : runs) {
                const SummaryLine* line = find(run, named.name);
                text += "<td class=\"number\">" + (line ? mean_with_scatter(*line) : "–") + "</td>";
            }
            text += "</tr>\n";
        }
    return text + "</tbody></table></div>\n";
}

std::string summary_section(std::span<const Results> runs, const std::vector<std::string>& labels) {
    std::string text = "<h2>Summary</h2>\n";
    bool any = false;
    for (const Results& run : runs) any = any || !run.quantities.empty();
    if (!any) return text + "<p>No summary yet: it is written when a run ends.</p>\n";
    return text + (runs.size() == 1 ? summary_of_one(runs.front()) : summary_of_many(runs, labels));
}

std::string checks_section(std::span<const Results> runs, const std::vector<std::string>& labels) {
    std::string text =
        "<h2>Checks</h2>\n<div class=\"scroll\"><table><caption>Worst over the whole "
        "run.</caption>\n<thead><tr>";
    if (runs.size() > 1) text += "<th scope=\"col\">run</th>";
    text +=
        "<th scope=\"col\">check</th><th scope=\"col\">worst</th><th scope=\"col\">limit</th><th "
        "scope=\"col\">verdict</th>"
        "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < runs.size(); ++r)
        for (const Check& check : checks(runs[r])) {
            const std::string verdict = check.worst.empty() ? "not recorded"
                                        : check.raised      ? "look: " + check.meaning
                                                            : "in order";
            text += fmt::format("<tr{}>", check.raised ? " class=\"raised\"" : "");
            if (runs.size() > 1) text += "<td>" + html(labels[r]) + "</td>";
            text += fmt::format(
                "<th scope=\"row\">{}</th><td>{}</td><td>{}</td><td "
                "class=\"meaning\">{}</td></tr>\n",
                html(check.name), html(check.worst), html(check.limit), html(verdict));
        }
    return text + "</tbody></table></div>\n";
}

/// A vector image, unless it is so rich in points that the raster is the smaller one.
std::string image_source(const std::filesystem::path& stem) {
    constexpr std::size_t rich = 200'000;
    const std::string svg = read_file(stem.string() + ".svg");
    if (svg.size() < rich) return "data:image/svg+xml;base64," + base64(svg);
    return "data:image/png;base64," + base64(read_file(stem.string() + ".png"));
}

std::string figures_section(const std::vector<Figure>& figures,
                            const std::filesystem::path& folder) {
    std::string text = "<h2>Figures</h2>\n";
    if (figures.empty()) return text + "<p>Nothing to draw yet.</p>\n";
    text +=
        "<p class=\"soft\">Each figure lies in figures/ as PNG and SVG, with its data and the "
        "gnuplot script that draws it.</p>\n"
        "<div class=\"figures\">\n";
    for (const Figure& figure : figures) {
        const std::string data = fmt::format(" · <a href=\"figures/{}.dat\">data</a>",
                                             figure.name == "flow" ? "flow_1_speed" : figure.name);
        text += fmt::format(
            "<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1} <a "
            "href=\"figures/{2}.svg\">SVG</a> · "
            "<a href=\"figures/{2}.png\">PNG</a>{3} · <a "
            "href=\"figures/{2}.gp\">script</a></figcaption></figure>\n",
            image_source(folder / figure.name), html(figure.caption), figure.name, data);
    }
    return text + "</div>\n";
}

constexpr const char* player_markup = R"(<div id="player">
<canvas id="picture" role="img" aria-label="Cells in the channel, animated; the figures below show chosen times"></canvas>
<div class="controls">
<button id="play" type="button">Play</button>
<input id="scrub" type="range" min="0" max="0" value="0" step="1" aria-label="time">
<output id="clock"></output>
<label>speed <select id="pace"><option value="0.25">¼×</option><option value="0.5">½×</option><option value="1" selected>1×</option>
<option value="2">2×</option><option value="4">4×</option></select></label>
<label><input id="background" type="checkbox" checked> speed of the flow</label>
<label id="which-label">run <select id="which"></select></label>
<span class="scale" id="legend">λ_C <span id="low"></span> <canvas id="scale" width="144" height="12" aria-hidden="true"></canvas>
<span id="high"></span></span>
</div>
</div>
)";

/// What the page left out of the frames, in words.
std::string player_note(const Json& player) {
    const std::size_t recorded = player["recorded"], embedded = player["times"].size();
    const int nodes = player["first"].back(), all_nodes = player["nodes_recorded"],
              block = player["block"];
    std::string text = fmt::format("{}: ", html(player["label"].get<std::string>()));
    text += embedded == recorded ? fmt::format("all {} frames", recorded)
                                 : fmt::format("{} of {} frames", embedded, recorded);
    if (nodes < all_nodes) text += fmt::format(", {} of {} nodes", nodes, all_nodes);
    text += fmt::format(", positions rounded to {:.2g} nm", player["quantum"].get<double>() * 1e9);
    text += block == 1 ? ", speed at every site"
                       : fmt::format(", speed averaged over {0} × {0} sites", block);
    return text +
           fmt::format(" (darkest blue {:.3g} mm/s).", player["fastest"].get<double>() * 1e3);
}

std::string player_section(const Json& players) {
    std::string text = "<h2>Cells over time</h2>\n";
    if (players.empty()) return text + "<p>No frames were recorded.</p>\n";
    text += player_markup;
    text += "<p class=\"soft\">";
    for (const Json& player : players) text += player_note(player) + " ";
    return text +
           "Frames are shown as recorded, nothing between them is invented; all of them are in "
           "frames.h5.</p>\n";
}

constexpr const char* charts_markup = R"(<div id="series"><h2>Time series</h2>
<p class="soft">Drag across a chart to look closer, double-click to go back. All columns are in series.csv and cells.csv.</p>
<div class="charts">
<div class="chart" data-key="lambda_C"><label>show <select></select></label> <span class="soft meaning"></span><div class="place"></div></div>
<div class="chart" data-key="taylor_inertia"><label>show <select></select></label> <span class="soft meaning"></span><div class="place"></div></div>
</div></div>
)";

std::string provenance_rows(const Json& json, const std::string& prefix = "") {
    std::string text;
    for (const auto& [key, value] : json.items()) {
        if (value.is_object()) {
            text += provenance_rows(value, prefix + key + " ");
            continue;
        }
        const std::string shown = value.is_string()
                                      ? value.get<std::string>()
                                      : value.dump(-1, ' ', false, Json::error_handler_t::replace);
        text += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"word\">{}</td></tr>\n",
                            html(prefix + key), html(shown));
    }
    return text;
}

std::string provenance_section(std::span<const Results> runs,
                               const std::vector<std::string>& labels) {
    std::string text = "<h2>Provenance</h2>\n";
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs[r].provenance.empty()) continue;
        text += fmt::format(
            "<details{}><summary>{}</summary><div "
            "class=\"scroll\"><table><tbody>\n{}</tbody></table></div></details>\n",
            runs.size() == 1 ? " open" : "", html(labels[r]), provenance_rows(runs[r].provenance));
    }
    return text;
}

std::string repeat_section(std::span<const Results> runs) {
    std::string text =
        "<h2>How to repeat</h2>\n<p>resolved.toml holds every setting, defaults included. With the "
        "same version and "
        "compiler flags (see provenance) the results come out the same to the bit, on any number "
        "of threads.</p>\n<pre>";
    for (const Results& run : runs)
        text += html(fmt::format("tanktread run {}/resolved.toml -o {}-again\n",
                                 run.directory.string(), run.name));
    text += html("tanktread report");
    for (const Results& run : runs) text += html(" " + run.directory.string());
    return text + "</pre>\n";
}

/// JSON that cannot end the script element it stands in.
std::string embedded(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t k = 0; (k = text.find('<', k)) != std::string::npos;)
        text.replace(k, 1, "\\u003c");
    return text;
}

}  // namespace

std::string html(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string report_page(std::span<const Results> runs, const std::vector<Figure>& figures,
                        const std::filesystem::path& figures_folder, PageLimits limits) {
    const std::vector<std::string> labels = run_labels(runs);
    limits.node_bytes /= runs.size();
    limits.field_bytes /= runs.size();
    Json data{{"runs", Json::array()}, {"players", Json::array()}};
    std::string title = runs.size() == 1 ? labels.front() : "Comparison of ";
    std::string text;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        if (runs.size() > 1) title += (r ? ", " : "") + labels[r];
        data["runs"].push_back(chart_data(runs[r], labels[r], limits));
        Json player = player_data(runs[r], labels[r], limits);
        if (!player.is_null()) data["players"].push_back(std::move(player));
        const std::string name = runs.size() == 1 ? "" : "<b>" + html(labels[r]) + "</b>: ";
        text += "<p>" + name + html(case_in_words(runs[r])) + "</p>\n";
        if (const std::string note = unfinished_note(runs[r]); !note.empty())
            text += "<p class=\"notice\">" + name + html(note) + "</p>\n";
    }
    text += player_section(data["players"]);
    text += checks_section(runs, labels) + summary_section(runs, labels);
    text += figures_section(figures, figures_folder) + charts_markup;
    text += repeat_section(runs) + provenance_section(runs, labels);

    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<meta "
        "http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src "
        "'unsafe-inline'\">\n";
    page += "<title>" + html(title) + "</title>\n<style>\n";
    page.append(assets::chart_style).append(assets::page_style);
    page += "</style>\n</head>\n<body>\n<h1>" + html(title) + "</h1>\n" + text;
    page += fmt::format(
        "<p class=\"soft\">Written by tanktread {}. Charts by "
        "uPlot:</p>\n<details><summary>licence of uPlot</summary>"
        "<pre>{}</pre></details>\n",
        version, html(assets::chart_licence));
    page +=
        "<script type=\"application/json\" id=\"data\">" + embedded(data) + "</script>\n<script>\n";
    page.append(assets::chart_script).append("\n</script>\n<script>\n").append(assets::page_script);
    return page + "</script>\n</body>\n</html>\n";
}

}  // namespace tt
