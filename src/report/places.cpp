#include "report/places.hpp"

#include <cmath>

#include <fmt/format.h>

#include "report/gnuplot.hpp"
#include "report/html.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

bool read_point(const Json& json, const char* key, double* point) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array() || found->size() != 2) return false;
    for (std::size_t k = 0; k < 2; ++k) {
        if (!(*found)[k].is_number()) return false;
        point[k] = (*found)[k].get<double>();
    }
    return true;
}

double value_of(const Results& run, const std::string& name, const char* key = "value") {
    const auto found = run.summary.find(name);
    return found == run.summary.end() || !found->is_object() ? NAN : number_of(*found, key, NAN);
}

void add_rows(const Results& run, const std::string& label, const Json& fork, HtmlTable& table) {
    if (!fork.is_object() || !fork.contains("daughters")) return;
    const std::string name = text_of(fork, "name");
    for (const Json& daughter : fork["daughters"]) {
        const auto section = daughter.is_string() ? daughter.get<std::string>() : "";
        const std::string start = name + "." + section + ".";
        const double cells = value_of(run, start + "cell_fraction", "cells");
        const double of = value_of(run, start + "cell_fraction", "of");
        std::vector<std::string> texts{
            name + ": " + section,
            number_text(value_of(run, start + "flow_fraction"), 3),
            with_scatter(value_of(run, start + "cell_fraction"),
                         value_of(run, start + "cell_fraction", "standard_error")),
            std::isfinite(cells) ? fmt::format("{:.0f} of {:.0f}", cells, of) : "–",
            number_text(value_of(run, start + "pries_cell_fraction"), 3),
            number_text(value_of(run, start + "hematocrit_ratio"), 3)};
        if (!label.empty()) texts.insert(texts.begin(), label);
        table.add_row(texts);
    }
}

}  // namespace

std::vector<DrawnPlace> drawn_places(const Results& run) {
    std::vector<DrawnPlace> places;
    for (const char* kind : {"ports", "sections"}) {
        const auto list = run.places.find(kind);
        if (list == run.places.end() || !list->is_array()) continue;
        for (const Json& json : *list) {
            DrawnPlace place;
            place.port = kind[0] == 'p';
            if (!json.is_object() || !read_point(json, "from", place.from) ||
                !read_point(json, "to", place.to))
                continue;
            place.name = text_of(json, "name");
            places.push_back(place);
        }
    }
    return places;
}

Json places_data(const Results& run) {
    Json list = Json::array();
    if (!run.frames) return list;
    const std::vector<double>& origin = run.frames->header().origin;
    const auto local = [&](const double* p) {
        return Json{p[0] - (origin.empty() ? 0.0 : origin[0]),
                    p[1] - (origin.empty() ? 0.0 : origin[1])};
    };
    for (const DrawnPlace& place : drawn_places(run))
        list.push_back({{"name", place.name},
                        {"port", place.port},
                        {"from", local(place.from)},
                        {"to", local(place.to)}});
    return list;
}

std::string places_commands(const Results& run) {
    std::string text;
    for (const DrawnPlace& place : drawn_places(run)) {
        const double x0 = 1e6 * place.from[0], y0 = 1e6 * place.from[1];
        const double x1 = 1e6 * place.to[0], y1 = 1e6 * place.to[1];
        text += fmt::format(
            "set arrow from first {:.6g}, first {:.6g} to first {:.6g}, first {:.6g} nohead front "
            "lc rgb \"{}\" lw {}\n",
            x0, y0, x1, y1, place.port ? "#1b7837" : "#222222", place.port ? 2.0 : 0.8);
        // Above an upright line, right of a level one.
        const bool upright = x0 == x1 || std::fabs(x1 - x0) < std::fabs(y1 - y0);
        text += fmt::format(
            "set label {} at first {:.6g}, first {:.6g} {} front noenhanced font \",9\" offset {} "
            "tc rgb \"#000000\"\n",
            gnuplot_string(place.name), upright ? x0 : std::fmax(x0, x1),
            upright ? std::fmax(y0, y1) : y0, upright ? "center" : "left",
            upright ? "0,0.4" : "0.4,0");
    }
    return text;
}

std::string forks_section(std::span<const Results> runs, const std::vector<std::string>& labels) {
    bool any = false;
    std::vector<HtmlTable::Column> columns{
        {"fork: daughter", ""},           {"share of the flow", "number"},
        {"share of the cells", "number"}, {"cells", "number"},
        {"Pries' law", "number"},         {"hematocrit / parent's", "number"}};
    const bool single = runs.size() == 1;
    if (!single) columns.insert(columns.begin(), {"run", ""});
    HtmlTable table("Within the averaging window. Cells are counted, with the binomial error.",
                    columns);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const auto forks = runs[r].places.find("forks");
        if (forks == runs[r].places.end() || !forks->is_array() || runs[r].summary.empty())
            continue;
        for (const Json& fork : *forks) {
            add_rows(runs[r], single ? "" : labels[r], fork, table);
            any = true;
        }
    }
    if (!any) return "";
    return heading("forks", "Forks") + table.text() +
           "<p class=\"soft\">Pries' law (Pries and Secomb 2005) is a fit to round microvessels of "
           "the rat. Of flat channels it is a curve to look at, not a bound.</p>\n";
}

}  // namespace tt
