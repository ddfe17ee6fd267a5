#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "fluid/walls.hpp"

namespace tt {

/// What is solid in the box of a case [m], from its lower left corner; empty for a straight
/// channel.
Solid solid_of(const Case& c);

/// The loops that the text of a file holds, one a block of lines. Throws CaseError with every fault
/// by line.
std::vector<Loop> read_loops(std::string_view text, const std::string& name, double unit);

/// How they lie on the grid, in words: "82.5 % of the box is open, narrowest gap 6 um …".
std::string description(const Walls& walls, double dx);

/// Why these walls cannot be run, and what to write: no sites are open, parts are not connected.
std::vector<std::string> faults_of(const Walls& walls, double dx);

/// The fewest sites across any gap between walls.
double narrowest_gap(const Walls& walls);

}  // namespace tt
