#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "fluid/collision/collision.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Which sites lie inside a cell: by the crossings of each lattice row with each outline.
struct ScanLine {};
/// The same by the paper's flood fill (its reference 27): mark the membrane, fill from a seed. The oracle of ScanLine.
struct FloodFill {};
using InteriorMethod = std::variant<ScanLine, FloodFill>;

/// How the viscosity passes from plasma to cytoplasm across a membrane.
struct SharpInterface {};                              ///< the site's own side
struct SmoothedInterface { double half_width = 2.0; };  ///< by signed distance over ± half_width sites
using InterfaceViscosity = std::variant<SharpInterface, SmoothedInterface>;

/// The two-viscosity model, lattice units.
struct ViscosityModel {
    InteriorMethod interior;
    InterfaceViscosity interface;
    Collision collision;
    double plasma = 1.0 / 6.0;     ///< kinematic viscosity outside
    double cytoplasm = 1.0 / 6.0;  ///< inside
    double layer_viscosity = 1.0 / 6.0;   ///< of a plain second fluid in 0 ≤ y < layer_thickness
    double layer_thickness = 0.0;
};

/// Fraction of cytoplasm per site, 0 … 1, and what the method keeps from step to step to update only what moved.
struct InteriorState {
    Field fraction;
    // private work arrays of the method follow; derived from the cells, never checkpointed
    std::vector<std::int32_t> work;
};

/// Recomputes fraction and relaxation rates from the outlines, from scratch.
void rebuild_viscosity(const ViscosityModel& model, const Suspension& cells, InteriorState& interior,
                       Relaxation& relaxation);

/// Brings both up to date after the membranes moved; gives the same bits as `rebuild_viscosity`. Team function.
void update_viscosity(const ViscosityModel& model, const Suspension& cells, InteriorState& interior,
                      Relaxation& relaxation);

}  // namespace tt
