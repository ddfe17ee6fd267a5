#pragma once

#include <cstdint>
#include <vector>

#include "simulation/state.hpp"

namespace tt {

/// The cells of a run by their numbers, those that left included: frames hold a place for each.
struct AllCells {
    std::vector<std::int32_t> first{0};  ///< nodes of cell number c are first[c] … first[c + 1]
    std::vector<double> rest_length;     ///< of their segments [sites]
    std::vector<std::int32_t> kind;
};
AllCells all_cells(const State& state);

/// Numbers x, y per node, in units of `unit`, as `all` has them; NaN of cells that left.
std::vector<double> per_node_of_all(const AllCells& all, const Suspension& cells,
                                    const std::vector<double>& x, const std::vector<double>& y,
                                    double unit);

}  // namespace tt
