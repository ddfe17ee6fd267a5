#pragma once

#include <filesystem>
#include <string>

#include "base/vec2.hpp"
#include "report/results.hpp"

namespace tt {

/// Where the panels stand, in pixels of the figure.
struct PanelGrid {
    int columns, rows;
    double panel_width, panel_height;
    static constexpr double left = 54, right = 14, gap_x = 26, gap_y = 24, top = 20;
    double bottom = 88;  ///< with room for a bar of colours
    int width() const {
        return static_cast<int>(
            std::ceil(left + right + columns * panel_width + (columns - 1) * gap_x));
    }
    int height() const {
        return static_cast<int>(std::ceil(top + bottom + rows * panel_height + (rows - 1) * gap_y));
    }
};

/// Long boxes one below the other at column width, square ones in two columns.
PanelGrid panel_grid(const FramesHeader& grid, int panels);

/// Gnuplot commands before all panels: the box of the run [µm] with its walls, ports and sections.
/// Writes walls.dat, the loops of walls, into `out`.
std::string panels_begin(const Results& run, const PanelGrid& layout,
                         const std::filesystem::path& out);

/// Commands that place panel k and keep labels only at the left and the bottom.
std::string panel_place(const PanelGrid& layout, int k, int panels);

/// Corner of the box in the coordinates of the drawing [µm].
Vec2 corner_um(const FramesHeader& grid);

/// What gnuplot plots of a file of places [µm] from the corner of the box: "using" of its columns.
std::string from_corner(const FramesHeader& grid);

/// The walls, as a further part of a plot command; nothing where there are none.
std::string plot_of_walls(const FramesHeader& grid);

}  // namespace tt
