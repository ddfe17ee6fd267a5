#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "report/results.hpp"

namespace tt {

/// Draws every figure that the results allow into `out` and returns what was drawn. One run: cells
/// and flow at chosen times, and each cell thin behind the mean. Several: their means overlaid, a
/// colour each. Precondition: can_draw().
std::vector<Figure> draw_figures(std::span<const Results> runs, const std::filesystem::path& out);

/// Every figure of one run, and its words for the page's note of those that were not drawn.
struct FigureName {
    std::string_view name, words;
};
inline constexpr FigureName all_figures[] = {
    {"flow", "cells and flow"},
    {"lambda_C", "perimeter extension ratio"},
    {"deformation", "Taylor deformation"},
    {"inclination", "inclination"},
    {"mu_rel", "apparent viscosity"},
    {"cell_free_layer", "cell-free layer"},
    {"area_error", "area error"},
    {"velocity_profile", "velocity profile"},
    {"hematocrit_profile", "hematocrit profile"},
};

using Column = std::vector<double>;
Column scaled(Column values, double factor);

/// The parts of draw_figures. Each appends what it could draw.
void draw_flow(const Results& run, const std::filesystem::path& out, std::vector<Figure>& drawn);
void draw_paths(const Results& run, const std::filesystem::path& out, std::vector<Figure>& drawn);
void draw_forks(const Results& run, const std::filesystem::path& out, std::vector<Figure>& drawn);
void draw_series(std::span<const Results> runs, const std::filesystem::path& out,
                 std::vector<Figure>& drawn);
void draw_profiles(std::span<const Results> runs, const std::filesystem::path& out,
                   std::vector<Figure>& drawn);

/// What each run is called in keys and tables: its name, with its directory where names repeat.
std::vector<std::string> run_labels(std::span<const Results> runs);

/// Puts the key of several runs below the figure, two in a row: over the curves, or beside them, it
/// would hide or squeeze them.
void key_below(LineFigure& figure, std::size_t runs);

/// A unit of time that makes `longest` [s] a number between 1 and 1000.
struct TimeUnit {
    double per_second;
    std::string name;
};
TimeUnit time_unit(double longest);

/// Frames with fields to show: those nearest to [output] figure_times of the case, else the start,
/// a quarter, half and the end.
std::vector<int> chosen_frames(const Results& run);

}  // namespace tt
