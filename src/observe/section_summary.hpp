#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/csv.hpp"
#include "io/json.hpp"
#include "observe/windows.hpp"

namespace tt {

/// An entry of summary.json: the mean of a column of a table over the window.
using Averaging =
    std::function<Json(const std::string& name, const Table& table, const std::vector<double>&)>;

/// Adds what sections.csv, left.csv and places.json tell.
///
/// NAME.hematocrit_discharge is the area of cells over the volume that passed within the window,
/// its error that of its rows. Of a fork, for each daughter D: FORK.D.flow_fraction and
/// FORK.D.cell_fraction of both daughters together, the latter by counts with the binomial error
/// √(f (1 − f)/N); FORK.D.hematocrit_ratio, its discharge hematocrit over that of the parent; and
/// FORK.D.pries_cell_fraction (observe/partition.hpp). PORT.residence is the mean time in the
/// channels of the cells that left there, of those there from the start the time since.
void summarise_sections(const std::filesystem::path& results, const Window& window,
                        const Averaging& average, Json& summary);
void summarise_residence(const std::filesystem::path& results, Json& summary);

}  // namespace tt
