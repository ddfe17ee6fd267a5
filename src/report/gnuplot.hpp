#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// A figure that was drawn: name.png, name.svg, name.gp and data files that start with the name.
struct Figure {
    std::string name;
    std::string caption;  ///< one or two sentences, also the alternative text of the page
    std::string fault;    ///< why it could not be drawn; empty: it was
};

/// One curve: columns of numbers and how gnuplot draws them, e.g. "using 1:2 with lines linetype
/// 1". A NaN in a row breaks the line there.
struct Curve {
    std::string title;  ///< entry of the key; empty: none
    std::string style;
    std::vector<std::vector<double>> columns;
};

/// A figure of one pair of axes.
struct LineFigure {
    std::string name, caption;
    std::vector<std::string> column_names;  ///< with units, for the head of the data file
    std::vector<std::string> commands;  ///< gnuplot commands before the plot: labels, ranges, marks
    std::vector<Curve> curves;
    int key_rows = 0;  ///< of a key below the figure, which grows by them; 0: no such key
};

/// Whether figures can be drawn here; else `no_gnuplot` says why, and what to do.
bool can_draw();
inline constexpr std::string_view no_gnuplot =
    "Figures need gnuplot, which is not installed; on Debian or Ubuntu: sudo apt install "
    "gnuplot-nox";

/// Whether any curve has a row of numbers only. gnuplot refuses a figure without.
bool has_points(const LineFigure& figure);

/// Text between gnuplot's single quotes.
std::string gnuplot_string(std::string_view text);

/// Writes name.dat (one block a curve) and name.gp and draws name.png and name.svg. Curves without
/// a row of numbers are left out. Precondition: has_points(figure).
void draw(const LineFigure& figure, const std::filesystem::path& out);

/// Appends a figure that `draw` draws. One that cannot be drawn is told, here and in its place, and
/// costs no other.
void add_figure(Figure figure, const std::function<void()>& draw, std::vector<Figure>& drawn);

/// The same of one pair of axes; nothing for a figure without points.
void add_figure(const LineFigure& figure, const std::filesystem::path& out,
                std::vector<Figure>& drawn);

/// Writes name.gp, which draws `body` (the plot commands) once as PNG and once as SVG of width ×
/// height pixels at column width (340 pixels = 86 mm; PNG at 3 times that, 300 dpi), and runs it.
/// The body may use nothing outside `out`.
void run_gnuplot(const std::filesystem::path& out, const std::string& name, const std::string& body,
                 int width, int height);

/// Writes style.gp, which every script loads, into `out`.
void write_style(const std::filesystem::path& out);

/// Writes text to a file whole. Throws IoError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace tt
