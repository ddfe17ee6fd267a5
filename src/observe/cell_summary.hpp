#pragma once

#include <vector>

#include "io/csv.hpp"
#include "observe/summary.hpp"

namespace tt {

/// The column `name` of a table in the window: all values, the means of its looks, those of each
/// cell where it is a table of cells.
struct Samples {
    std::vector<double> all, look_means;
    std::vector<std::vector<double>> cells;
};

Samples gather(const Table& table, const std::vector<double>& column, const SummaryInput& input);

/// Inclinations as if all cells were in the lower half of a channel, each within 90° of the axis
/// they have in the mean: an axis has no head, and −89° is beside 89°. Nothing where no cell keeps
/// its inclination: the mean of an axis that goes all round says where it lingers, not where it
/// stands.
std::vector<double> inclinations(const Table& cells, const SummaryInput& input);

/// k · period of each cell that treads.
Samples tank_treading_periods(const Table& cells, const SummaryInput& input);

/// How far each cell came across the flow per way along it, Δy/Δx from its first look in the window
/// to its last, of cells that came along by ten sites; of none in channels between ports.
Samples lateral_displacements(const Table& cells, const SummaryInput& input);

/// The rows of a table of cells that are of one kind.
Table rows_of_kind(const Table& cells, int kind);

}  // namespace tt
