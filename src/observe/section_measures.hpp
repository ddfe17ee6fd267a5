#pragma once

#include <vector>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// What of the cells lies on a section at one time. Sites.
struct SectionCells {
    double share = 0.0;                ///< of the line
    std::vector<double> share_of_row;  ///< of the spacing around each row of the line
    /// From each wall to the first membrane on the line; NaN where no cell is on it.
    double from_begin = 0.0, from_end = 0.0;
};
SectionCells cells_on_section(const SectionLine& line, const Lattice& lattice,
                              const Suspension& cells);

/// Area of the cells that has passed a section since the start, forward less backward: of those
/// that are on the line the part that has.
double carried_area(const Model& model, const State& state, std::size_t section);

}  // namespace tt
