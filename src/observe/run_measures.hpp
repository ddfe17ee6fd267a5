#pragma once

#include <span>

#include "observe/measures.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// All measures of the whole run at this step, SI (docs/theory/analysis.md). `cells` are the cells'
/// measures of the same step, all of them. NaN stands for what is not defined: means over cells
/// without cells, mu_app without a drive or before anything flows, the discharge hematocrit where
/// walls drive the flow, the cell-free layer without walls or cells.
RunMeasures measure_run(const Model& model, const State& state,
                        std::span<const CellMeasures> cells);

/// Mid-height of a channel whose walls do not drive its flow, about which the shear changes its
/// sign; NaN elsewhere.
Length mirror_height(const Model& model);

/// The inclination of a cell at height y as it would be in the lower half of a channel: means over
/// cells of both halves would cancel by symmetry otherwise.
double mirrored_inclination(double inclination, double y, double mirror_height);

/// Volume flux per unit depth through a cross-section, ∫ u_x dy averaged over x. Lattice units. The
/// sum over rows is the midpoint rule; between walls its error (u'(H) − u'(0))/24 is added, so that
/// the flux is of fourth order and exact for Poiseuille flow. The sum alone, which the flow
/// controller holds, is larger by 1/(2 ny²) there.
double flux(const Model& model, const State& state);

/// −dp/dx acting: body force and pressure drop per length. Lattice units.
double driving_gradient(const Model& model, const State& state);

/// Shear stress of the fluid on the walls from ∂u_x/∂y there, to second order, with the viscosity
/// of the sites at the wall, averaged along x and over both walls; lattice units. Where walls drive
/// the flow: σ_xy. Otherwise: what holds the flow back, the mean of σ_xy at the bottom and −σ_xy at
/// the top.
double wall_shear_stress(const Model& model, const State& state);

/// The same from the balance of momentum; equal to it once the flow is steady. Pressure-driven: ½ H
/// (−dp/dx). Sheared: Batchelor's mean stress, ⟨ν (∂u_x/∂y + ∂u_y/∂x)⟩ − Σ f_x y / V with the node
/// forces f, to which the cells' stress belongs (J. Fluid Mech. 41 (1970) 545). Lattice units.
double balance_shear_stress(const Model& model, const State& state);

}  // namespace tt
