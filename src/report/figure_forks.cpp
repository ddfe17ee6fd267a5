#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "observe/partition.hpp"
#include "report/figures.hpp"

namespace tt {
namespace {

double value_of(const Results& run, const std::string& name, const char* key = "value") {
    const auto found = run.summary.find(name);
    return found == run.summary.end() || !found->is_object() ? NAN : number_of(*found, key, NAN);
}

double width_of(const Json& sections, const std::string& name) {
    for (const Json& section : sections)
        if (section.is_object() && text_of(section, "name") == name)
            return number_of(section, "width", NAN);
    return NAN;
}

/// The curve of Pries' law for this daughter, from edge to edge.
Curve law_of(const Results& run, const Json& sections, const std::string& parent,
             const std::string& daughter, const std::string& other, int linetype) {
    const double hematocrit = value_of(run, parent + ".hematocrit_discharge");
    Curve curve{
        "Pries, " + daughter, fmt::format("using 1:2 with lines linetype {}", linetype), {{}, {}}};
    if (!std::isfinite(hematocrit)) return curve;
    const PriesLaw law(Length{width_of(sections, parent)}, Length{width_of(sections, daughter)},
                       Length{width_of(sections, other)}, hematocrit);
    constexpr int points = 200;
    for (int k = 0; k <= points; ++k) {
        const double x = static_cast<double>(k) / points;
        curve.columns[0].push_back(x);
        curve.columns[1].push_back(law.cell_fraction(x));
    }
    return curve;
}

void add_fork(const Results& run, const Json& sections, const Json& fork, LineFigure& figure) {
    if (!fork.is_object() || !fork.contains("daughters") || fork["daughters"].size() != 2) return;
    const std::string name = text_of(fork, "name"), parent = text_of(fork, "parent");
    std::array<std::string, 2> daughters;
    for (std::size_t n = 0; n < 2; ++n)
        if (fork["daughters"][n].is_string())
            daughters[n] = fork["daughters"][n].get<std::string>();
    for (std::size_t n = 0; n < 2; ++n) {
        const std::string start = name + "." + daughters[n] + ".";
        const int linetype = static_cast<int>(figure.curves.size()) / 2 + 1;
        const double error = value_of(run, start + "cell_fraction", "standard_error");
        figure.curves.push_back(
            law_of(run, sections, parent, daughters[n], daughters[1 - n], linetype));
        figure.curves.push_back(
            {daughters[n],
             fmt::format("using 1:2:3 with yerrorbars linetype {} pointtype 7 pointsize 0.6",
                         linetype),
             {{value_of(run, start + "flow_fraction")},
              {value_of(run, start + "cell_fraction")},
              {std::isfinite(error) ? error : 0.0}}});
    }
}

}  // namespace

void draw_forks(const Results& run, const std::filesystem::path& out, std::vector<Figure>& drawn) {
    const auto forks = run.places.find("forks"), sections = run.places.find("sections");
    if (forks == run.places.end() || sections == run.places.end() || !forks->is_array()) return;
    LineFigure figure;
    figure.name = "forks";
    figure.caption =
        "Share of the cells against share of the flow of each daughter of a fork, with the "
        "binomial error of the counts, within the averaging window. Lines: Pries' law for vessels "
        "as wide, a fit to round microvessels and no bound for flat channels. Dots on the thin "
        "diagonal would take cells as they take blood.";
    figure.column_names = {"share of the flow", "share of the cells", "its error"};
    figure.commands = {"set xlabel \"share of the flow\"",
                       "set ylabel \"share of the cells\"",
                       "set xrange [0:1]",
                       "set yrange [0:1]",
                       "set key top left samplen 1.2",
                       "set arrow from 0,0 to 1,1 nohead lc rgb \"#bbbbbb\" lw 0.7 back"};
    for (const Json& fork : *forks) add_fork(run, *sections, fork, figure);
    bool any = false;
    for (const Curve& curve : figure.curves)
        any = any || (curve.columns.size() == 3 && std::isfinite(curve.columns[0][0]) &&
                      std::isfinite(curve.columns[1][0]));
    if (!any) return;
    add_figure(figure, out, drawn);
}

}  // namespace tt
