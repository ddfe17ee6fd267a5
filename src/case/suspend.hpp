#pragma once

#include "case/case.hpp"
#include "case/random_layout.hpp"
#include "membrane/suspension.hpp"
#include "simulation/model.hpp"

namespace tt {

/// The cells of a case where they start. Throws CaseError where they do not fit, overlap, or reach
/// into a wall or a port.
Suspension suspended_cells(const Case& c, const Model& m, const LayoutWatch& watch);

/// The same of the channel that feeds a port.
Suspension cells_of_feed(const Case& c, const Model& network, const Feed& feed,
                         const LayoutWatch& watch);

/// Throws CaseError where cells overlap.
void refuse_overlaps(const Model& m, const Suspension& cells);

}  // namespace tt
