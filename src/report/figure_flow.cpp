#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/figures.hpp"
#include "report/frames.hpp"
#include "report/panels.hpp"
#include "report/places.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

constexpr int most_columns = 800;  ///< of the drawn field: finer than that is finer than print

/// Speed [m/s] on blocks of stride × stride sites, row after row from the bottom.
struct SpeedMap {
    int columns = 0, rows = 0, stride = 1;
    std::vector<double> speed;
};

SpeedMap speed_map(const FramesHeader& grid, const Frame& frame) {
    SpeedMap map;
    map.stride = (grid.nx + most_columns - 1) / most_columns;
    map.columns = grid.nx / map.stride;
    map.rows = grid.ny / map.stride;
    map.speed.assign(static_cast<std::size_t>(map.columns) * map.rows, 0.0);
    for (int j = 0; j < map.rows * map.stride; ++j)
        for (int i = 0; i < map.columns * map.stride; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * grid.nx + i;
            const std::size_t block =
                static_cast<std::size_t>(j / map.stride) * map.columns + i / map.stride;
            map.speed[block] += std::hypot(frame.velocity[2 * site], frame.velocity[2 * site + 1]) /
                                (map.stride * map.stride);
        }
    return map;
}

std::string matrix_text(const SpeedMap& map, double factor) {
    std::string text = fmt::format(
        "# speed, scaled by {:g} from m/s; one row of blocks a line, from the bottom\n", factor);
    for (int j = 0; j < map.rows; ++j) {
        for (int i = 0; i < map.columns; ++i)
            text += fmt::format("{}{:.4g}", i ? " " : "",
                                factor * map.speed[static_cast<std::size_t>(j) * map.columns + i]);
        text += '\n';
    }
    return text;
}

/// Closed outlines [µm], wrapped into the box; a cell across an end is written at both. A blank
/// line ends each.
std::string outlines_text(const FramesHeader& grid, const Frame& frame) {
    const std::vector<Vec2> nodes = wrapped_nodes(grid, frame);
    std::string text = "# x [um] y [um] cell; a blank line between outlines\n";
    for (int cell = 0; cell < cell_count(grid); ++cell) {
        const int begin = grid.first[static_cast<std::size_t>(cell)];
        const int end = grid.first[static_cast<std::size_t>(cell) + 1];
        for (const Vec2 shift : image_shifts(grid, nodes, cell)) {
            for (int k = begin; k <= end; ++k) {
                const Vec2 p = nodes[static_cast<std::size_t>(k == end ? begin : k)];
                text += fmt::format("{:.5g} {:.5g} {}\n", (p.x + shift.x) * 1e6,
                                    (p.y + shift.y) * 1e6, cell);
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace

std::vector<int> chosen_frames(const Results& run) {
    std::vector<double> wanted;
    const int last = run.frames->count() - 1;
    for (const double time : settings_si(run.setting("output.figure_times")))
        if (std::isfinite(time)) wanted.push_back(time);
    if (wanted.empty())
        for (const double share : {0.0, 0.25, 0.5, 1.0})
            wanted.push_back(share * run.frames->time(last));
    std::vector<int> frames;
    for (const double time : wanted)
        if (const auto k = nearest_field(*run.frames, time)) frames.push_back(*k);
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

void draw_flow(const Results& run, const fs::path& out, std::vector<Figure>& drawn) {
    if (!run.frames || run.frames->count() == 0) return;
    const FramesHeader& grid = run.frames->header();
    std::vector<Frame> frames;
    for (const int k : chosen_frames(run)) frames.push_back(run.frames->frame(k));
    if (frames.empty()) return;

    const PanelGrid layout = panel_grid(grid, static_cast<int>(frames.size()));
    const TimeUnit unit = time_unit(run.frames->time(run.frames->count() - 1));
    double fastest = 0.0;
    std::vector<SpeedMap> maps;
    for (const Frame& frame : frames) {
        maps.push_back(speed_map(grid, frame));
        for (const double speed : maps.back().speed) fastest = std::max(fastest, speed);  // not NaN
    }
    const bool slow = fastest < 1e-3;
    const double factor = slow ? 1e6 : 1e3;
    const Vec2 corner = corner_um(grid);
    std::string body =
        panels_begin(run, layout, out) +
        fmt::format(
            "set palette defined (0 \"#f7fbff\", 0.25 \"#c6dbef\", 0.5 \"#6baed6\", 0.75 "
            "\"#2d7dbb\", 1 \"#0b4a8f\")\nset cbrange [0:{:.4g}]\n",
            std::max(fastest * factor, 1e-9));
    if (!grid.wall_first.empty())  // where there is no speed, in walls, the ground shows
        body +=
            "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb \"#8a8a8a\" fs solid "
            "noborder\n";
    const int panels = static_cast<int>(frames.size());
    for (int k = 0; k < panels; ++k) {
        const std::string stem = fmt::format("flow_{}", k + 1);
        const auto index = static_cast<std::size_t>(k);
        write_text(out / (stem + "_speed.dat"), matrix_text(maps[index], factor));
        write_text(out / (stem + "_cells.dat"), outlines_text(grid, frames[index]));
        body += panel_place(layout, k, panels);
        body += fmt::format("set title \"{{/:Italic t}} = {:.4g} {}\" offset 0,-0.7\n",
                            frames[index].time * unit.per_second, unit.name);
        body += k + 1 < panels
                    ? "unset colorbox\n"
                    : fmt::format(
                          "set colorbox user horizontal origin {:.4f},{:.4f} size "
                          "{:.4f},{:.4f}\nset cblabel "
                          "\"speed [{}]\" offset 0,0.5\nset cbtics scale 0.3 offset 0,0.4\n",
                          PanelGrid::left / layout.width(), 38.0 / layout.height(),
                          1.0 - (PanelGrid::left + PanelGrid::right) / layout.width(),
                          7.0 / layout.height(), slow ? "μm/s" : "mm/s");
        const double block = grid.dx * maps[index].stride * 1e6;
        body += fmt::format(
            "plot \"{0}_speed.dat\" matrix using "
            "({2:.8g}+({1:.8g})*($1+0.5)):({3:.8g}+({1:.8g})*($2+0.5)):3 with image",
            stem, block, corner.x, corner.y);
        body += plot_of_walls(grid);
        if (grid.first.back() > 0)
            body += fmt::format(
                ", \\\n     \"{0}_cells.dat\" {1} with filledcurves closed fc rgb "
                "\"#c8372d\" fillstyle "
                "transparent solid 0.8 noborder, \\\n     \"\" {1} with lines lc rgb "
                "\"#5c0d08\" lw 0.7",
                stem, from_corner(grid));
        body += "\n";
    }
    body += "unset multiplot";
    std::string caption = "Cells (red) and speed of the flow at chosen times.";
    if (grid.origin.empty())
        caption +=
            " Flow is along x, which is periodic: a cell that crosses an end appears at both.";
    if (!drawn_places(run).empty()) caption += " Ports are green lines, sections thin ones.";
    add_figure(
        {"flow", caption, ""},
        [&] { run_gnuplot(out, "flow", body, layout.width(), layout.height()); }, drawn);
}

}  // namespace tt
