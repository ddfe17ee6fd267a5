#pragma once

#include "observe/flow_gradient.hpp"
#include "observe/plasma_map.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Shear stress at one cell's membrane, largest over its nodes, by two definitions; lattice units
/// (density 1, so stress = kinematic viscosity × rate). The paper does not say which it uses for
/// τ_max of Eq. 24.
///
/// `traction`: the shear traction |t·σ·n| of the plasma on the membrane's outside, with σ =
/// ν_plasma (∇u + ∇uᵀ). A membrane is smeared over two sites to either side, where ∇u is neither
/// that of the plasma nor that of the cytoplasm, so σ is sampled on the outward normal at 3 and 5
/// sites and extrapolated linearly to the membrane: second order in the site spacing, and low by 7
/// % where σ ~ 1/r² about a cell of 20 sites' radius (tests/unit/cell_measures.cpp). Where a
/// wall, another cell's smeared membrane or the cell itself reaches the second sample, the first is
/// taken as it stands; where it reaches the first, the node is left out. So gaps below some 5 sites
/// are not seen. NaN if no node can be sampled.
///
/// `principal`: the largest principal shear rate × local viscosity at the site nearest to each
/// node, as a lattice Boltzmann code finds it without further thought: within the smeared membrane,
/// hence between the stresses of either side, and dependent on the kernel and on how viscosity is
/// smoothed.
struct MembraneStress {
    double traction = 0.0;
    double principal = 0.0;
};
MembraneStress membrane_stress(const Model& model, const State& state, const PlasmaMap& plasma,
                               int cell);

}  // namespace tt
