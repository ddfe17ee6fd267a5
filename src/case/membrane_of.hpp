#pragma once

#include "base/quantity.hpp"
#include "case/case.hpp"
#include "membrane/forces.hpp"

namespace tt {

/// The hardening that a case describes. Numbers without dimension.
Hardening hardening_of(const HardeningCase& h);

/// The membrane that a case describes, in the units of `scales`; SI with Scales{}. Its area
/// stiffness is left to who chooses it.
Membrane membrane_of(const MembraneCase& m, const Scales& scales);

/// Whether very small gaps repel: where the case says so, and between walls of any shape, where
/// cells come to rest on corners.
bool repels(const Case& c);

/// Whether the cells are drops: nothing holds their nodes apart.
bool is_drop(const MembraneCase& m);

/// Whether nodes move with what their move makes of the tension: where the case wants it, and not
/// on a drop, whose tension does not depend on stretch.
bool tension_is_implicit(const Case& c);

}  // namespace tt
