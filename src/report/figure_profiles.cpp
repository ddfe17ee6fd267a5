#include <cmath>

#include <fmt/format.h>

#include "report/figures.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Width between the walls: rows of sites stand half a spacing away from them.
double wall_distance(const Column& y) { return y.size() < 2 ? 0.0 : y.back() + y.front(); }

/// A unit of velocity that keeps the axis readable.
struct VelocityUnit {
    double per_si;
    std::string name;
};

VelocityUnit velocity_unit(std::span<const Results> runs) {
    double fastest = 0.0;
    for (const Results& run : runs)
        for (const double u : values(run.profiles, "velocity"))
            fastest = std::max(fastest, std::abs(u));
    return fastest < 1e-3 ? VelocityUnit{1e6, "μm/s"} : VelocityUnit{1e3, "mm/s"};
}

/// Velocity that a straight line through the two outermost rows has at the wall, half a spacing
/// away.
double at_wall(double outermost, double next) { return outermost - 0.5 * (next - outermost); }

/// The profile without cells of the same flux: 6 U y (H − y)/H² between resting walls; between
/// moving walls the straight line from wall to wall, moved to the same mean U. Empty if the case
/// does not say how the flow is driven.
Column profile_of_plasma(const Results& run) {
    const Column& y = values(run.profiles, "y");
    const Column& u = values(run.profiles, "velocity");
    const double width = wall_distance(y);
    const std::string drive = run.setting("flow.drive");
    const bool channel = drive == "pressure" || drive == "body-force";
    if (u.size() < 2 || width <= 0.0 || (!channel && drive != "shear")) return {};
    double mean = 0.0;
    for (const double value : u) mean += value / static_cast<double>(u.size());
    const double rate = (at_wall(u.back(), u[u.size() - 2]) - at_wall(u[0], u[1])) / width;
    Column plasma;
    for (const double height : y)
        plasma.push_back(channel ? 6.0 * mean * height * (width - height) / (width * width)
                                 : mean + rate * (height - 0.5 * width));
    return plasma;
}

LineFigure across(std::span<const Results> runs, const std::string& name,
                  const std::string& x_label) {
    LineFigure figure;
    figure.name = name;
    double width = 0.0;
    for (const Results& run : runs)
        width = std::max(width, wall_distance(values(run.profiles, "y")));
    figure.commands = {"set xlabel \"" + x_label + "\"", "set ylabel \"{/:Italic y} [μm]\"",
                       fmt::format("set yrange [0:{:.6g}]", width * 1e6), "set border 7"};
    return figure;
}

/// Dashes mean plasma alone up to so many runs; of more they tell the runs apart.
constexpr std::size_t most_with_plasma = 4;

void draw_velocity(std::span<const Results> runs, const fs::path& out, std::vector<Figure>& drawn) {
    const VelocityUnit unit = velocity_unit(runs);
    LineFigure figure = across(runs, "velocity_profile", "velocity [" + unit.name + "]");
    figure.column_names = {"velocity [" + unit.name + "]", "y [um]"};
    const std::vector<std::string> labels = run_labels(runs);
    const bool single = runs.size() == 1;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Column y = scaled(values(runs[r].profiles, "y"), 1e6);
        const Column u = scaled(values(runs[r].profiles, "velocity"), unit.per_si);
        if (u.empty()) continue;
        figure.curves.push_back({single ? "with cells" : labels[r],
                                 fmt::format("using 1:2 with lines linetype {}", r + 1),
                                 {u, y}});
        const Column plasma = scaled(profile_of_plasma(runs[r]), unit.per_si);
        if (plasma.empty() || runs.size() > most_with_plasma) continue;
        const std::string dashed = single ? "linetype 7" : fmt::format("linetype {}", r + 1);
        const std::string title =
            runs[r].setting("flow.drive") == "shear" ? "Couette flow" : "Poiseuille, same flux";
        figure.curves.push_back({single ? title : "",
                                 "using 1:2 with lines " + dashed + " dashtype 2 lw 1.1",
                                 {plasma, y}});
    }
    figure.caption = "Velocity along the channel, averaged over its length and over the window.";
    if (runs.size() <= most_with_plasma)
        figure.caption += " Dashed: the flow of plasma alone with the same flux.";
    if (single)
        figure.commands.push_back("set key outside top center horizontal samplen 1.2");
    else
        key_below(figure, runs.size());
    add_figure(figure, out, drawn);
}

/// Shades both cell-free layers of a single run and writes their width beside them.
void mark_layers(LineFigure& figure, const Results& run) {
    const double bottom = window_mean(run, "cfl_profile_bottom") * 1e6;
    const double top = window_mean(run, "cfl_profile_top") * 1e6;
    const double width = wall_distance(values(run.profiles, "y")) * 1e6;
    if (!std::isfinite(bottom) || !std::isfinite(top)) return;
    const std::string fill = "fc rgb \"#f6e3c5\" fillstyle solid noborder behind";
    figure.commands.push_back(fmt::format(
        "set object 1 rectangle from graph 0, first 0 to graph 1, first {:.6g} {}", bottom, fill));
    figure.commands.push_back(
        fmt::format("set object 2 rectangle from graph 0, first {:.6g} to graph 1, first {:.6g} {}",
                    width - top, width, fill));
    figure.commands.push_back(
        fmt::format("set label 1 \"cell-free layer {:.2f} μm\" at graph 0.97, first {:.6g} right",
                    bottom, 0.5 * bottom));
    figure.commands.push_back(
        fmt::format("set label 2 \"cell-free layer {:.2f} μm\" at graph 0.97, first {:.6g} right",
                    top, width - 0.5 * top));
}

void draw_hematocrit(std::span<const Results> runs, const fs::path& out,
                     std::vector<Figure>& drawn) {
    LineFigure figure = across(runs, "hematocrit_profile", "local hematocrit");
    figure.column_names = {"hematocrit", "y [um]"};
    const std::vector<std::string> labels = run_labels(runs);
    const bool single = runs.size() == 1;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Column& h = values(runs[r].profiles, "hematocrit");
        if (h.empty()) continue;
        figure.curves.push_back({single ? "" : labels[r],
                                 fmt::format("using 1:2 with lines linetype {}", r + 1),
                                 {h, scaled(values(runs[r].profiles, "y"), 1e6)}});
    }
    figure.caption =
        "Share of the cells' interior at each height, averaged over the length and over the "
        "window.";
    figure.commands.push_back("set xrange [0:*]");
    if (single) {
        mark_layers(figure, runs.front());
        figure.caption +=
            " Shaded: the cell-free layers, wall to where the profile reaches half its maximum.";
    } else {
        key_below(figure, runs.size());
    }
    add_figure(figure, out, drawn);
}

}  // namespace

void draw_profiles(std::span<const Results> runs, const fs::path& out, std::vector<Figure>& drawn) {
    draw_velocity(runs, out, drawn);
    draw_hematocrit(runs, out, drawn);
}

}  // namespace tt
