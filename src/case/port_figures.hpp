#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/choose.hpp"

namespace tt {

/// What plasma alone does at a port.
struct PortFigures {
    Length width;
    Pressure pressure;
    KinematicViscosity flow_rate;  ///< into the channels, per depth
    Velocity mean_velocity;
};
PortFigures figures_of(const Case& c, const Choice& choice, std::size_t port);

/// How long the flow of a network takes to answer a change: as the lattice fluid can be compressed,
/// half of what its area A holds must pass its largest resistance, ½ · 3 A · Δp/Q, which is
/// 6 (τ − ½) (L/H)² steps of a straight channel.
Time late_answer(const Choice& choice);
std::string late_answer_text(const Choice& choice);

}  // namespace tt
