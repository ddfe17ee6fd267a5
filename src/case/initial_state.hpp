#pragma once

#include "case/case.hpp"
#include "case/random_layout.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Cells placed and the fluid at rest or in its undisturbed flow ([flow] start). Throws CaseError
/// where the cells do not fit (random layout short of its hematocrit, overlaps, a node outside the
/// walls). `watch` is told how far a random layout has come.
State initial_state(const Case& c, const Model& model, const LayoutWatch& watch = {});

}  // namespace tt
