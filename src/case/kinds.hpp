#pragma once

#include <cstdint>
#include <vector>

#include "case/case.hpp"

namespace tt {

/// The case as it would be if all its cells were of one kind, for each of its kinds in their order:
/// sizes, shapes and limits of the step are judged by these. The case itself where it has no
/// [[kind]]; with plasma in the place of what is within a rigid body. Their `count` and `positions`
/// are those of the kind, if it has them.
std::vector<Case> cases_by_kind(const Case& c);

/// [cells], and every kind.
std::vector<CellTypeCase*> cell_types(Case& c);

/// Of the kinds, the radius of the circle of the stress-free area.
Length smallest_cell_radius(const Case& c);
Length largest_cell_radius(const Case& c);

/// G = μ k a/E_s (Eq. 19) of cells of one kind, at the shear rate `rate`, either sign; 0 of a rigid
/// body.
double shear_number_at(const Case& one, Rate rate);

/// By how many times the viscosities inside and outside differ, whichever is the larger, at most.
double viscosity_contrast(const Case& c);

/// How many cells of each kind there are in a room of this area, if those of each kind take
/// `areas`; their sum is a multiple of `multiple`. Those with a `count` have it. The others share
/// the rest of cells.count, or of the area that cells.hematocrit leaves, by their `share`, each
/// rounded such that the total is kept.
std::vector<int> cells_of_kinds(const Case& c, const std::vector<double>& areas, double room,
                                int multiple = 1);

/// The kind of each of the cells, in an order that is as good as random.
std::vector<int> mixed(const std::vector<int>& numbers, std::uint64_t seed);

}  // namespace tt
