#pragma once

#include "case/appraise.hpp"

namespace tt {

/// What `check` says of the kinds of cells, where there are several: a line for each.
void print_kinds(const Appraisal& a);

/// What the viscosity of membranes does in two dimensions (docs/theory/membrane-viscosity.md).
void print_membrane_viscosity(const Appraisal& a);

}  // namespace tt
