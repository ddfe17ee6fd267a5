#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/results.hpp"

namespace tt {

/// A port or section as it is drawn: its ends [m], in the coordinates of the drawing.
struct DrawnPlace {
    std::string name;
    bool port = false;
    double from[2] = {0.0, 0.0}, to[2] = {0.0, 0.0};
};
/// Of places.json; what is damaged is left out.
std::vector<DrawnPlace> drawn_places(const Results& run);

/// The same for the player, [{name, port, from, to}] in metres from the corner of the box.
Json places_data(const Results& run);

/// Gnuplot commands that draw them [um].
std::string places_commands(const Results& run);

/// How flow and cells part at each fork, beside Pries' law: a table; empty where there is no fork.
std::string forks_section(std::span<const Results> runs, const std::vector<std::string>& labels);

}  // namespace tt
