#include <cmath>
#include <map>

#include <fmt/format.h>

#include "report/figures.hpp"
#include "report/frames.hpp"
#include "report/panels.hpp"

namespace tt {
namespace {

struct Place {
    double x, y;  ///< from the corner of the box [m]
};

/// Where each cell was at each of its times, from the start on.
std::map<int, std::vector<Place>> places_of_cells(const Results& run) {
    const FramesHeader& grid = run.frames->header();
    const Column &cell = values(run.cells, "cell"), &x = values(run.cells, "x"),
                 &y = values(run.cells, "y");
    const double left = grid.origin.empty() ? 0.0 : grid.origin[0];
    const double low = grid.origin.empty() ? 0.0 : grid.origin[1];
    std::map<int, std::vector<Place>> places;
    if (x.size() == cell.size() && y.size() == cell.size())
        for (std::size_t k = 0; k < cell.size(); ++k)
            places[static_cast<int>(cell[k])].push_back({x[k] - left, y[k] - low});
    return places;
}

/// Wrapped into the box; a blank line wherever a path goes on at the other end [µm].
std::string paths_text(const FramesHeader& grid, const std::map<int, std::vector<Place>>& places) {
    std::string text = "# x [um] y [um] cell; a blank line where a path goes on at another end\n";
    for (const auto& [cell, path] : places) {
        double column = 0.0, row = 0.0;
        for (std::size_t k = 0; k < path.size(); ++k) {
            if (!std::isfinite(path[k].x + path[k].y)) continue;
            const double c = std::floor(path[k].x / grid.length);
            const double r = std::floor(path[k].y / grid.width);
            if (k > 0 && (c != column || r != row)) text += '\n';
            column = c;
            row = r;
            text += fmt::format("{:.5g} {:.5g} {}\n", (path[k].x - c * grid.length) * 1e6,
                                (path[k].y - r * grid.width) * 1e6, cell);
        }
        text += "\n";
    }
    return text;
}

}  // namespace

void draw_paths(const Results& run, const std::filesystem::path& out, std::vector<Figure>& drawn) {
    if (!run.frames || run.frames->header().wall_first.empty()) return;
    const FramesHeader& grid = run.frames->header();
    const auto places = places_of_cells(run);
    if (places.empty()) return;
    PanelGrid layout = panel_grid(grid, 1);
    layout.bottom = 48;  // no bar
    write_text(out / "paths.dat", paths_text(grid, places));
    std::string body = panels_begin(run, layout, out) + panel_place(layout, 0, 1);
    body += "plot \"paths.dat\" " + from_corner(grid) + ":3 with lines lc variable lw 1.2" +
            plot_of_walls(grid) + "\nunset multiplot";
    const std::string caption =
        "Paths of the middle of each cell, from its start to the end of the run or to the port "
        "where it left. A path that crosses an end of a periodic box goes on at the other.";
    add_figure(
        {"paths", caption, ""},
        [&] { run_gnuplot(out, "paths", body, layout.width(), layout.height()); }, drawn);
}

}  // namespace tt
