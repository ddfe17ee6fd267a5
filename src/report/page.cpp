#include "report/page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/version.hpp"
#include "io/file.hpp"
#include "report/assets.hpp"
#include "report/failure_section.hpp"
#include "report/figures.hpp"
#include "report/html.hpp"
#include "report/key_numbers.hpp"
#include "report/page_tables.hpp"
#include "report/places.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// A vector image, unless it is so rich in points that the raster is the smaller one.
std::string image_source(const fs::path& stem) {
    constexpr std::size_t rich = 200'000;
    const std::string svg = read_file(stem.string() + ".svg");
    if (svg.size() < rich) return "data:image/svg+xml;base64," + base64(svg);
    return "data:image/png;base64," + base64(read_file(stem.string() + ".png"));
}

std::string link(const std::string& file, std::string_view text) {
    return fmt::format("<a href=\"figures/{}\">{}</a>", html(file), text);
}

std::string figure_markup(const Figure& figure, const fs::path& folder) {
    if (!figure.fault.empty())
        return fmt::format("<figure><figcaption>Not drawn: {}. {}</figcaption></figure>\n",
                           html(figure.name), html(figure.fault));
    const std::string data = figure.name == "flow" ? "flow_1_speed.dat" : figure.name + ".dat";
    return fmt::format(
        "<figure><img src=\"{}\" alt=\"{}\"><figcaption>{} {} · {} · {} · "
        "{}</figcaption></figure>\n",
        image_source(folder / figure.name), html(figure.caption), html(figure.caption),
        link(figure.name + ".svg", "SVG"), link(figure.name + ".png", "PNG"), link(data, "data"),
        link(figure.name + ".gp", "script"));
}

/// The figures of one run that its results have no data for.
std::string left_out_note(const std::vector<Figure>& figures) {
    std::string list;
    for (const FigureName& each : all_figures) {
        const auto drawn = [&](const Figure& f) { return f.name == each.name; };
        if (std::any_of(figures.begin(), figures.end(), drawn)) continue;
        list.append(list.empty() ? "" : ", ").append(each.words);
    }
    if (list.empty()) return "";
    return fmt::format(
        "<p class=\"soft\">Left out, as these results have no data for them: {}.</p>\n", list);
}

std::string figures_section(const std::vector<Figure>& figures, const fs::path& folder,
                            const std::string& note) {
    std::string text = heading("figures", "Figures");
    if (figures.empty())
        return text +
               fmt::format("<p>{}</p>\n", can_draw() ? "Nothing to draw yet." : html(no_gnuplot));
    text +=
        "<p class=\"soft\">Each lies in figures/ as PNG and SVG, with its data and the gnuplot "
        "script that draws it.</p>\n<div class=\"figures\">\n";
    for (const Figure& figure : figures) text += figure_markup(figure, folder);
    return text + "</div>\n" + note;
}

/// What the page left out of the frames, in words.
std::string player_note(const Json& run) {
    const Json& player = run["player"];
    if (player.is_null()) return html(run["label"].get<std::string>()) + ": no frames. ";
    const std::size_t recorded = player["recorded"], embedded = player["times"].size();
    const int nodes = player["first"].back(), all_nodes = player["nodes_recorded"];
    const int block = player["block"];
    std::string text = html(run["label"].get<std::string>());
    text += embedded == recorded ? fmt::format(": all {} frames", recorded)
                                 : fmt::format(": {} of {} frames", embedded, recorded);
    if (nodes < all_nodes) text += fmt::format(", {} of {} nodes", nodes, all_nodes);
    text += fmt::format(", positions rounded to {:.2g} nm", player["quantum"].get<double>() * 1e9);
    return text + (block == 1 ? ", speed at every site. "
                              : fmt::format(", speed averaged over {0} × {0} sites. ", block));
}

std::string player_section(const Json& runs) {
    std::string text = heading("cells", "Cells over time");
    const auto plays = [](const Json& run) { return !run["player"].is_null(); };
    if (std::none_of(runs.begin(), runs.end(), plays))
        return text + "<p>No frames were recorded.</p>\n";
    text.append(assets::player_markup).append("<p class=\"soft\">");
    for (const Json& run : runs) text += player_note(run);
    return text +
           "Frames are shown as recorded, with nothing made up between them; all of them "
           "are in frames.h5.</p>\n";
}

/// A path as a shell and the program take it, whatever it is called.
std::string shell_word(const std::string& text) {
    const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("/._-+=:,").find(c) != std::string_view::npos;
    });
    const std::string path = text.front() == '-' ? "./" + text : text;
    if (plain) return path;
    std::string word = "'";
    for (const char c : path) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

std::string repeat_section(std::span<const Results> runs) {
    std::string text =
        heading("repeat", "How to repeat") +
        "<p>resolved.toml holds every setting, defaults included. With the "
        "same version and compiler flags (see provenance) the results come out the same to the "
        "bit, on any number of threads.</p>\n<pre>";
    std::string again;
    for (const Results& run : runs) {
        const std::string folder = (run.directory / "").parent_path().string();
        text += html(fmt::format("tanktread run {} -o {}\n", shell_word(folder + "/resolved.toml"),
                                 shell_word(folder + "-again")));
        again += ' ' + shell_word(folder + "-again");
    }
    return text + html("tanktread report" + again) + "</pre>\n";
}

/// What was run, and whether it ended; of several, the first and in what the others differ.
std::string introduction(std::span<const Results> runs, const std::vector<std::string>& labels) {
    const bool single = runs.size() == 1;
    std::string text = single ? "" : fmt::format("<p>The first run, {}:</p>\n", html(labels[0]));
    text += "<p>" + html(case_in_words(runs.front())) + "</p>\n";
    if (!single) text += differences_section(runs, labels);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const std::string name = single ? "" : fmt::format("<b>{}</b>: ", html(labels[r]));
        const std::string note = unfinished_note(runs[r]);
        if (!note.empty()) text += "<p class=\"notice\">" + name + html(note) + "</p>\n";
        if (const std::string changes = changes_note(runs[r]); !changes.empty())
            text += "<p class=\"notice\">" + name + html(changes) + "</p>\n";
        text += failure_section(runs[r], labels[r], fmt::format("failure-{}", r + 1));
        for (const std::string& fault : runs[r].faults)
            text += "<p class=\"notice\">" + name + html(fault) + "</p>\n";
    }
    return text;
}

std::string page_title(const std::vector<std::string>& labels) {
    if (labels.size() == 1) return labels.front();
    if (labels.size() > 3) return fmt::format("Comparison of {} runs", labels.size());
    return fmt::format("Comparison of {}", fmt::join(labels, ", "));
}

/// Data of charts and player, each run with its share of the limits.
Json page_data(std::span<const Results> runs, const std::vector<std::string>& labels,
               PageLimits limits) {
    limits.node_bytes /= runs.size();
    limits.field_bytes /= runs.size();
    limits.cell_bytes /= runs.size();
    Json data{{"runs", Json::array()}};
    for (std::size_t r = 0; r < runs.size(); ++r)
        data["runs"].push_back(run_data(runs[r], labels[r], limits));
    return data;
}

}  // namespace

std::string report_page(std::span<const Results> runs, const std::vector<Figure>& figures,
                        const fs::path& figures_folder, const PageLimits& limits) {
    const std::vector<std::string> labels = run_labels(runs);
    const Json data = page_data(runs, labels, limits);
    const std::string title = html(page_title(labels));

    std::string body = key_numbers_section(runs, labels) + player_section(data["runs"]);
    body += checks_section(runs, labels) + summary_section(runs, labels);
    body += forks_section(runs, labels);
    body +=
        figures_section(figures, figures_folder, runs.size() == 1 ? left_out_note(figures) : "");
    body += heading("series", "Time series");
    body.append(assets::charts_markup);
    body += repeat_section(runs) + provenance_section(runs, labels);

    std::string page(assets::page_head);
    page += "<title>" + title + "</title>\n<style>\n";
    page.append(assets::chart_style).append(assets::page_style);
    page += "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
    const std::string start = introduction(runs, labels);
    page += start + contents_list(start + body) + body;
    page += fmt::format(
        "<p class=\"soft\">Written by tanktread {}; charts by uPlot.</p>\n<details>"
        "<summary>Licence of uPlot</summary><pre>{}</pre></details>\n",
        html(version_text()), html(assets::chart_licence));
    page +=
        "<script type=\"application/json\" id=\"data\">" + embedded(data) + "</script>\n<script>\n";
    page.append(assets::chart_script).append("\n</script>\n<script>\n").append(assets::page_script);
    return page + "</script>\n</body>\n</html>\n";
}

}  // namespace tt
