#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "report/figures.hpp"

#include "base/undefined.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// The runs with the marks that all their figures over time share.
struct TimePlots {
    std::span<const Results> runs;
    std::vector<std::string> labels;
    TimeUnit unit;
    bool single() const { return runs.size() == 1; }
};

double longest_time(std::span<const Results> runs) {
    double longest = 0.0;
    for (const Results& run : runs)
        for (const double t : values(run.series, "time")) longest = std::max(longest, t);
    return longest;
}

Column times(const Results& run, const TimeUnit& unit) {
    return scaled(values(run.series, "time"), unit.per_second);
}

/// Axes, and the averaging window in grey when there is one run to average.
LineFigure over_time(const TimePlots& plots, const std::string& name, const std::string& y_label) {
    LineFigure figure;
    figure.name = name;
    figure.column_names = {"time [" + plots.unit.name + "]"};
    figure.commands = {
        "set xlabel \"time [" + plots.unit.name + "]\"", "set ylabel \"" + y_label + "\"",
        fmt::format("set xrange [0:{:.7g}]", longest_time(plots.runs) * plots.unit.per_second)};
    if (!plots.single()) key_below(figure, plots.runs.size());
    const Results& run = plots.runs.front();
    if (plots.single() && run.window_end > run.window_begin)
        figure.commands.push_back(fmt::format(
            "set object 1 rectangle from first {:.6g}, graph 0 to first {:.6g}, graph 1 fc rgb "
            "\"#efefef\" "
            "fillstyle solid noborder behind",
            run.window_begin * plots.unit.per_second, run.window_end * plots.unit.per_second));
    return figure;
}

std::string window_note(const TimePlots& plots) {
    const Results& run = plots.runs.front();
    return plots.single() && run.window_end > run.window_begin ? " Grey: the averaging window."
                                                               : "";
}

/// Every cell's curve one after the other, a NaN row between them.
std::pair<Column, Column> cell_curves(const Results& run, const std::string& column,
                                      double time_factor) {
    const Column& time = values(run.cells, "time");
    const Column& cell = values(run.cells, "cell");
    const Column& value = values(run.cells, column);
    if (value.empty() || cell.empty() || time.empty()) return {};
    std::map<double, std::pair<Column, Column>> by_cell;
    for (std::size_t k = 0; k < value.size(); ++k) {
        by_cell[cell[k]].first.push_back(time[k] * time_factor);
        by_cell[cell[k]].second.push_back(value[k]);
    }
    std::pair<Column, Column> joined;
    for (auto& [number, curve] : by_cell) {
        joined.first.insert(joined.first.end(), curve.first.begin(), curve.first.end());
        joined.second.insert(joined.second.end(), curve.second.begin(), curve.second.end());
        joined.first.push_back(undefined);
        joined.second.push_back(undefined);
    }
    return joined;
}

/// Adds one column of the series of every run; the key names the runs where there are several.
void add_column(LineFigure& figure, const TimePlots& plots, const std::string& column,
                const std::string& title, double factor, int first_linetype) {
    for (std::size_t r = 0; r < plots.runs.size(); ++r) {
        const Column& series = values(plots.runs[r].series, column);
        if (series.empty()) continue;
        const int linetype = plots.single() ? first_linetype : static_cast<int>(r) + 1;
        figure.curves.push_back({plots.single() ? title : plots.labels[r],
                                 fmt::format("using 1:2 with lines linetype {}", linetype),
                                 {times(plots.runs[r], plots.unit), scaled(series, factor)}});
    }
    figure.column_names.push_back(column);
}

/// More bands than these hide each other.
constexpr std::size_t most_bands = 4;

/// Mean ± standard deviation over cells as a band; each cell thin when there is one run.
LineFigure stretch_figure(const TimePlots& plots) {
    LineFigure figure = over_time(plots, "lambda_C", "perimeter extension ratio {/:Italic λ}_C");
    figure.caption =
        "Perimeter extension ratio λ_C over time: mean over cells" +
        std::string(plots.single() ? " (thick) ± standard deviation (band), each cell thin."
                    : plots.runs.size() <= most_bands ? " ± standard deviation (band)."
                                                      : ".") +
        window_note(plots);
    if (plots.single()) figure.commands.push_back("set key bottom right");
    const std::size_t bands = plots.runs.size() > most_bands ? 0 : plots.runs.size();
    for (std::size_t r = 0; r < bands; ++r) {
        const Column time = times(plots.runs[r], plots.unit);
        const Column& mean = values(plots.runs[r].series, "lambda_C");
        const Column& sd = values(plots.runs[r].series, "lambda_C_sd");
        if (mean.empty() || sd.size() != mean.size()) continue;
        Column low(mean), high(mean);
        for (std::size_t k = 0; k < mean.size(); ++k) {
            low[k] -= sd[k];
            high[k] += sd[k];
        }
        figure.curves.push_back(
            {plots.single() ? "mean ± sd" : "",
             fmt::format(
                 "using 1:2:3 with filledcurves linetype {} fillstyle transparent solid 0.22 "
                 "noborder",
                 r + 1),
             {time, low, high}});
    }
    if (plots.single()) {
        auto [time, value] = cell_curves(plots.runs[0], "lambda_C", plots.unit.per_second);
        figure.curves.push_back(
            {"each cell", "using 1:2 with lines lc rgb \"#8c8c8c\" lw 0.5", {time, value}});
    }
    add_column(figure, plots, "lambda_C", "mean", 1.0, 1);
    figure.column_names = {figure.column_names[0], "lambda_C (bands: mean - sd, mean + sd)"};
    return figure;
}

LineFigure deformation_figure(const TimePlots& plots) {
    LineFigure figure = over_time(plots, "deformation", "Taylor deformation {/:Italic D}");
    figure.caption =
        "Taylor deformation, mean over cells" +
        std::string(plots.single() ? ", by the inertia-equivalent ellipse and by the extreme radii."
                                   : ", by the inertia-equivalent ellipse.") +
        window_note(plots);
    if (plots.single()) figure.commands.push_back("set key bottom right");
    add_column(figure, plots, "taylor_inertia", "inertia ellipse", 1.0, 1);
    if (plots.single()) add_column(figure, plots, "taylor_extent", "extreme radii", 1.0, 2);
    return figure;
}

LineFigure inclination_figure(const TimePlots& plots) {
    LineFigure figure = over_time(plots, "inclination", "inclination [°]");
    figure.caption = "Inclination of the long axis to the flow, mean over cells" +
                     std::string(plots.single() ? " (thick), each cell thin." : ".") +
                     window_note(plots);
    if (plots.single()) {
        figure.commands.push_back("set key outside top center horizontal samplen 1.2");
        auto [time, value] = cell_curves(plots.runs[0], "inclination_deg", plots.unit.per_second);
        // A long axis that turns past 90° reappears at −90°: break the line there.
        for (std::size_t k = value.size(); k-- > 1;)
            if (std::abs(value[k] - value[k - 1]) > 90.0) value[k] = undefined;
        figure.curves.push_back(
            {"each cell", "using 1:2 with lines lc rgb \"#8c8c8c\" lw 0.5", {time, value}});
    }
    add_column(figure, plots, "inclination_deg", "mean", 1.0, 1);
    return figure;
}

LineFigure viscosity_figure(const TimePlots& plots) {
    LineFigure figure =
        over_time(plots, "mu_rel", "relative apparent viscosity {/:Italic μ}_{rel}");
    figure.caption =
        "Apparent viscosity divided by that of the plasma (Eq. 23) over time." + window_note(plots);
    add_column(figure, plots, "mu_rel", "", 1.0, 1);
    return figure;
}

LineFigure area_figure(const TimePlots& plots) {
    LineFigure figure =
        over_time(plots, "area_error", "largest |{/:Italic A} / {/:Italic A}_{ref} − 1|");
    figure.caption = "Largest relative area error of any cell over time.";
    add_column(figure, plots, "area_error_max", "", 1.0, 1);
    for (Curve& curve : figure.curves)
        for (double& value : curve.columns[1])  // round-off before the first step is no error
            value = std::abs(value) < 1e-12 ? undefined : std::abs(value);
    figure.commands.insert(figure.commands.end(), {"set logscale y", "set format y \"10^{%L}\""});
    return figure;
}

LineFigure layer_figure(const TimePlots& plots) {
    LineFigure figure = over_time(plots, "cell_free_layer", "cell-free layer [μm]");
    figure.caption =
        plots.single()
            ? "Cell-free layer, mean of both walls, by four definitions: smallest gap to the wall, "
              "mean envelope of the membranes, half maximum of the hematocrit profile, and a "
              "uniform "
              "core of the peak hematocrit." +
                  window_note(plots)
            : "Cell-free layer by the half maximum of the hematocrit profile, mean of both walls.";
    figure.commands.push_back("set yrange [0:*]");
    add_column(figure, plots, "cfl_profile", "half maximum", 1e6, 1);
    if (plots.single()) {
        add_column(figure, plots, "cfl_envelope", "mean envelope", 1e6, 2);
        add_column(figure, plots, "cfl_core", "uniform core", 1e6, 3);
        add_column(figure, plots, "cfl_gap", "smallest gap", 1e6, 4);
        figure.commands.push_back("set key outside top center horizontal samplen 1.2 width -1");
    }
    return figure;
}

}  // namespace

void draw_series(std::span<const Results> runs, const fs::path& out, std::vector<Figure>& drawn) {
    if (longest_time(runs) <= 0.0) return;
    const TimePlots plots{runs, run_labels(runs), time_unit(longest_time(runs))};
    for (auto make : {stretch_figure, deformation_figure, inclination_figure, viscosity_figure,
                      layer_figure, area_figure})
        add_figure(make(plots), out, drawn);
}

}  // namespace tt
