#include "report/panels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/gnuplot.hpp"
#include "report/places.hpp"

namespace tt {
namespace {

/// The loops of walls [µm]; a blank line ends each.
std::string walls_text(const FramesHeader& grid) {
    std::string text = "# x [um] y [um] of walls; a blank line between loops\n";
    for (std::size_t w = 0; w + 1 < grid.wall_first.size(); ++w) {
        const std::int32_t begin = grid.wall_first[w], end = grid.wall_first[w + 1];
        for (std::int32_t k = begin; k <= end && begin < end; ++k) {
            const auto at = 2 * static_cast<std::size_t>(k == end ? begin : k);
            text += fmt::format("{:.6g} {:.6g}\n", grid.walls[at] * 1e6, grid.walls[at + 1] * 1e6);
        }
        text += '\n';
    }
    return text;
}

/// A step of 1, 2 or 5 times a power of ten that cuts `extent` into 3 to 6 parts or so.
double round_step(double extent) {
    const double raw = extent / 4.0;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    const double lead = raw / decade;
    return decade * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

constexpr const char* common = R"(set multiplot
set border 15 lw 0.6
set tics out scale 0.4
unset key
)";

}  // namespace

PanelGrid panel_grid(const FramesHeader& grid, int panels) {
    const double aspect = grid.length / grid.width;
    PanelGrid layout{aspect < 2.0 && panels > 1 ? 2 : 1, 1, 0.0, 0.0};
    layout.rows = (panels + layout.columns - 1) / layout.columns;
    const double room = 340.0 * (layout.columns == 2 ? 1.2 : 1.0);
    layout.panel_width =
        (room - PanelGrid::left - PanelGrid::right - (layout.columns - 1) * PanelGrid::gap_x) /
        layout.columns;
    layout.panel_height = layout.panel_width / aspect;
    return layout;
}

std::string panel_place(const PanelGrid& layout, int k, int panels) {
    const int row = k / layout.columns, column = k % layout.columns;
    const double x0 = PanelGrid::left + column * (layout.panel_width + PanelGrid::gap_x);
    const double y1 =
        layout.height() - PanelGrid::top - row * (layout.panel_height + PanelGrid::gap_y);
    const double w = layout.width(), h = layout.height();
    std::string text = fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
                                   x0 / w, (x0 + layout.panel_width) / w);
    text += fmt::format("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n",
                        (y1 - layout.panel_height) / h, y1 / h);
    const bool lowest = k + layout.columns >= panels;
    text += lowest ? "set xlabel \"{/:Italic x} [μm]\" offset 0,0.4\nset format x \"%g\"\n"
                   : "unset xlabel\nset format x \"\"\n";
    text += column == 0 ? "set ylabel \"{/:Italic y} [μm]\" offset 0,0\nset format y \"%g\"\n"
                        : "unset ylabel\nset format y \"\"\n";
    return text;
}

Vec2 corner_um(const FramesHeader& grid) {
    return grid.origin.empty() ? Vec2{} : Vec2{grid.origin[0] * 1e6, grid.origin[1] * 1e6};
}

std::string from_corner(const FramesHeader& grid) {
    const Vec2 corner = corner_um(grid);
    return fmt::format("using ($1+({:.8g})):($2+({:.8g}))", corner.x, corner.y);
}

std::string plot_of_walls(const FramesHeader& grid) {
    if (grid.wall_first.empty()) return "";
    return fmt::format(", \\\n     \"walls.dat\" {} with lines lc rgb \"#4a4a4a\" lw 0.7",
                       from_corner(grid));
}

std::string panels_begin(const Results& run, const PanelGrid& layout,
                         const std::filesystem::path& out) {
    const FramesHeader& grid = run.frames->header();
    std::string body = common;
    if (layout.panel_height < 120.0) body += fmt::format("set ytics {:.3g}\n", grid.width * 0.5e6);
    if (layout.columns > 1)
        body += fmt::format("set xtics {:g}\nset ytics {:g}\n", round_step(grid.length * 1e6),
                            round_step(grid.width * 1e6));
    const Vec2 corner = corner_um(grid);
    body += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", corner.x,
                        corner.x + grid.length * 1e6, corner.y, corner.y + grid.width * 1e6);
    if (!grid.wall_first.empty()) write_text(out / "walls.dat", walls_text(grid));
    return body + places_commands(run);
}

}  // namespace tt
