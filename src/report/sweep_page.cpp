#include "report/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "io/file.hpp"
#include "observe/sweep_record.hpp"
#include "report/assets.hpp"
#include "report/html.hpp"
#include "report/results.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// The distinct combinations of values on an axis, and the place of each run among them.
struct AxisPlaces {
    std::vector<std::vector<std::string>> values;  ///< a place each, of each of its keys
    std::vector<std::size_t> of_run;
};

AxisPlaces places_on(const SweepRecord& sweep, std::size_t first_key, std::size_t keys) {
    AxisPlaces places;
    for (const SweptRun& run : sweep.runs) {
        const auto begin = run.values.begin() + static_cast<std::ptrdiff_t>(first_key);
        const std::vector<std::string> own(begin, begin + static_cast<std::ptrdiff_t>(keys));
        const auto at = std::find(places.values.begin(), places.values.end(), own);
        places.of_run.push_back(static_cast<std::size_t>(at - places.values.begin()));
        if (at == places.values.end()) places.values.push_back(own);
    }
    return places;
}

/// "20 um" cut into its number and unit; nothing if it is no quantity.
struct Written {
    double number = 0.0;
    std::string unit;
};
std::optional<Written> written(const std::string& text) {
    const std::size_t length = number_length(text);
    if (length == 0) return std::nullopt;
    try {
        parse_measure(text);
        const std::size_t unit = std::min(text.find_first_not_of(' ', length), text.size());
        return Written{parse_measure(text.substr(0, length)).si, text.substr(unit)};
    } catch (const UnitError&) {
        return std::nullopt;
    }
}

std::string pretty_unit(std::string unit) {
    if (unit == "um") return "µm";
    return unit;
}

/// Values of a key as numbers of the unit in which all were written, else in SI; none if they are
/// words.
Json key_json(const std::string& key, const std::string& name, const AxisPlaces& places,
              std::size_t place) {
    Json json{{"key", key}, {"short", name}, {"unit", ""}, {"values", Json::array()}};
    Json numbers = Json::array();
    bool alike = true, all = true;
    std::string unit;
    for (const auto& values : places.values) {
        json["values"].push_back(values[place]);
        const auto value = written(values[place]);
        all = all && value;
        if (!value) continue;
        alike = alike && (numbers.empty() || value->unit == unit);
        unit = value->unit;
        numbers.push_back(value->number);
    }
    if (!all) return json;
    if (!alike) {
        numbers.clear();
        const Dimension dimension = parse_measure(places.values.front()[place]).dimension;
        const DisplayUnit display = display_unit(si_unit(dimension));
        for (const auto& values : places.values)
            numbers.push_back(parse_measure(values[place]).si * display.factor);
        unit = display.name;
    }
    json["unit"] = pretty_unit(unit);
    json["numbers"] = numbers;
    return json;
}

/// The page of a run where it has one, else its directory.
std::string link_to(const fs::path& directory, const SweptRun& run, const fs::path& from) {
    const fs::path place = (directory / run.directory).lexically_normal();
    const fs::path page = place / "report.html";
    return (fs::exists(page) ? page : place / "").lexically_relative(from).generic_string();
}

Json sweep_data(const fs::path& directory, const SweepRecord& sweep, const fs::path& out) {
    Json data{{"axes", Json::array()}, {"quantities", Json::array()}, {"runs", Json::array()}};
    std::vector<AxisPlaces> all_places;
    const std::vector<std::string> names = short_keys(sweep.keys());
    std::size_t first = 0;
    for (const auto& axis : sweep.axes) {
        all_places.push_back(places_on(sweep, first, axis.size()));
        Json keys = Json::array();
        for (std::size_t k = 0; k < axis.size(); ++k)
            keys.push_back(key_json(axis[k], names[first + k], all_places.back(), k));
        data["axes"].push_back({{"keys", keys}});
        first += axis.size();
    }
    std::vector<std::string> quantities;
    std::vector<double> factors;
    const fs::path from = fs::absolute(out / "").parent_path();
    for (std::size_t r = 0; r < sweep.runs.size(); ++r) {
        const SweptRun& run = sweep.runs[r];
        const bool done = run.ending == RunEnding::done;
        std::vector<Json> means(quantities.size());
        for (const SummaryMean& mean :
             done ? summary_means(directory / run.directory) : std::vector<SummaryMean>{}) {
            const auto at = static_cast<std::size_t>(
                std::find(quantities.begin(), quantities.end(), mean.name) - quantities.begin());
            if (at == quantities.size()) {
                const DisplayUnit unit = display_unit(mean.unit);
                quantities.push_back(mean.name);
                factors.push_back(unit.factor);
                means.emplace_back();
                data["quantities"].push_back({{"name", mean.name},
                                              {"unit", unit.name},
                                              {"meaning", meaning_of_quantity(mean.name)}});
            }
            means[at] = {number(mean.mean * factors[at]),
                         number(mean.standard_error * factors[at])};
        }
        Json places = Json::array();
        for (const AxisPlaces& axis : all_places) places.push_back(axis.of_run[r]);
        data["runs"].push_back(
            {{"number", r + 1},
             {"name", run.name},
             {"link", link_to(fs::absolute(directory), run, from)},
             {"places", places},
             {"ending", word_of(run.ending)},
             {"checks",
              done ? fmt::format("{}", fmt::join(raised_checks(directory / run.directory), " "))
                   : ""},
             {"means", means}});
    }
    for (Json& run : data["runs"])
        while (run["means"].size() < quantities.size()) run["means"].push_back(nullptr);
    return data;
}

/// "0.1; 0.2; 0.3 … 1", with how many where they are many: a value may hold commas.
std::string listed(const std::vector<std::string>& values) {
    constexpr std::size_t most = 12;
    if (values.size() <= most) return fmt::format("{}", fmt::join(values, "; "));
    return fmt::format("{}; {}; {} … {} ({} values)", values[0], values[1], values[2],
                       values.back(), values.size());
}

/// The keys that differ, and what all runs share.
std::string introduction(const fs::path& directory, const SweepRecord& sweep) {
    HtmlTable table("What differs.", {{"key", ""}, {"values", "word"}});
    std::size_t first = 0;
    for (const auto& axis : sweep.axes) {
        const AxisPlaces places = places_on(sweep, first, axis.size());
        for (std::size_t k = 0; k < axis.size(); ++k) {
            std::vector<std::string> values;
            for (const auto& place : places.values) values.push_back(place[k]);
            table.add_row(
                {axis[k],
                 listed(values) + (k > 0 ? fmt::format(" (together with {})", axis[0]) : "")});
        }
        first += axis.size();
    }
    std::string text = table.text();
    for (const SweptRun& run : sweep.runs) {
        if (run.ending != RunEnding::done) continue;
        try {
            text += fmt::format("<p>Of the first run, {}: {}</p>\n", html(run.name),
                                html(case_in_words(read_results(directory / run.directory))));
        } catch (const IoError&) {  // gone meanwhile: the next may be there
            continue;
        }
        break;
    }
    return text;
}

std::string endings(const SweepRecord& sweep) {
    std::size_t done = 0, failed = 0;
    std::string list;
    for (const SweptRun& run : sweep.runs) {
        if (run.ending == RunEnding::done) ++done;
        if (run.ending != RunEnding::failed) continue;
        ++failed;
        list += fmt::format("<li>{}: {}</li>\n", html(run.name), html(run.why));
    }
    std::string text = fmt::format("<p>{} of {} runs are done{}.", done, sweep.runs.size(),
                                   failed > 0 ? fmt::format(", {} failed", failed) : "");
    if (const std::size_t open = sweep.runs.size() - done - failed; open > 0)
        text += fmt::format(" {} are to do: the page shows what there is.", open);
    text += " All numbers are in <a href=\"table.csv\">table.csv</a>.</p>\n";
    return list.empty() ? text
                        : text + "<div class=\"notice\">Failed:<ul>\n" + list + "</ul></div>\n";
}

}  // namespace

std::string sweep_page(const fs::path& directory, const fs::path& out) {
    const SweepRecord sweep = read_sweep_record(directory);
    const std::string title = html(sweep.name);
    std::string page(assets::page_head);
    page += "<title>" + title + "</title>\n<style>\n";
    page.append(assets::page_style).append(assets::sweep_style);
    page += "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
    std::string body = introduction(directory, sweep);
    body.append(assets::sweep_markup).append(heading("repeat", "How to repeat"));
    body += fmt::format(
        "<p>sweep.toml and inputs/ hold all that was asked for.</p>\n<pre>{}</pre>\n",
        html(fmt::format("tanktread sweep {} -o {} --fresh",
                         shell_quoted((directory / "sweep.toml").string()),
                         shell_quoted((directory / "").parent_path().string() + "-again"))));
    page += endings(sweep) + contents_list(body) + body;
    page += fmt::format("<p class=\"soft\">Written by tanktread {}.</p>\n", html(version_text()));
    page += "<script type=\"application/json\" id=\"data\">" +
            embedded(sweep_data(directory, sweep, out)) + "</script>\n<script>\n";
    page.append(assets::sweep_script);
    return page + "</script>\n</body>\n</html>\n";
}

fs::path write_sweep_page(const fs::path& directory, const fs::path& out) {
    const fs::path place = out.empty() ? directory : out;
    make_directory(place);
    const fs::path page = place / "report.html";
    replace_file(page, sweep_page(directory, place), Durability::process);
    return page;
}

}  // namespace tt
