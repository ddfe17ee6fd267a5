#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "case/layout.hpp"
#include "grid/lattice.hpp"

namespace tt {

/// Cells at random places and angles, and what it took to find them.
struct RandomLayout {
    std::vector<Placement> cells;
    double scale = 1.0;       ///< 1: they have their full size; smaller: the largest that fits
    std::int64_t visits = 0;  ///< how often a cell was looked at
};

/// Told while cells are placed: their number and the share of their area that they have.
using LayoutWatch = std::function<void(int cells, double filled)>;

/// Grows a crowd in the box: first as hard particles that wander (case/growth.hpp), as long as that
/// is cheap; then pressed against each other (case/pressing.hpp). The same for the same seed, on
/// every machine.
RandomLayout lay_at_random(const Crowd& crowd, const Room& room, std::uint64_t seed,
                           const LayoutWatch& watch = {});

/// The same, at full size. Throws CaseError where they do not fit, with a number of cells that
/// does; `where` it was asked for.
std::vector<Placement> random_placements(const Crowd& crowd, const Room& room, std::uint64_t seed,
                                         const LayoutWatch& watch = {},
                                         const std::string& where = "[cells] layout = \"random\"");

}  // namespace tt
