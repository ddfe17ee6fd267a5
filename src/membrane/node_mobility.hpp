#pragma once

namespace tt {

/// By which a load per length that is state moves a node, (τ + ½)/ν of a plasma of this kinematic
/// viscosity: the fluid's stress follows its velocity τ − ½ steps late
/// (docs/theory/membrane-viscosity.md).
constexpr double node_mobility(double plasma) { return 1.0 / plasma + 3.0; }

}  // namespace tt
