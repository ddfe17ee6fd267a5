#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "coupling/interface/area_fraction.hpp"
#include "coupling/interface/sharp.hpp"
#include "coupling/interface/smoothed.hpp"
#include "coupling/interior/flood_fill.hpp"
#include "coupling/interior/scanline.hpp"
#include "coupling/patch.hpp"
#include "coupling/viscosity_mean.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Which sites lie inside a cell.
using InteriorMethod = std::variant<ScanLine, FloodFill>;

/// How the fraction of cytoplasm passes from 0 to 1 across a membrane. Another way is one more
/// struct with `reach()` and a call operator that fills a patch.
using InterfaceViscosity = std::variant<SharpInterface, SmoothedInterface, AreaFraction>;

/// The two-viscosity model, lattice units.
struct ViscosityModel {
    InteriorMethod interior;
    InterfaceViscosity interface;
    ViscosityMean mean;
    Collision collision;
    double plasma = 1.0 / 6.0;           ///< kinematic viscosity outside
    double cytoplasm = 1.0 / 6.0;        ///< inside
    double layer_viscosity = 1.0 / 6.0;  ///< of a plain second fluid in 0 ≤ y < layer_thickness
    double layer_thickness = 0.0;
    double refresh_distance = 0.25;  ///< a cell is laid anew once a node is this far from where it
                                     ///< was laid, about as far ahead; 0: always
};

/// One cell's share in the fraction field, now and before the last refresh.
struct CellPatch {
    Patch now, before;
    LocalOutline local;
    bool refreshed = false;
};

/// Fraction of cytoplasm per site, and what it was made from.
struct InteriorState {
    Field<> fraction;  ///< 0 … 1; where cells overlap their fractions add up; exact, so in double
    /// Where each node was when its cell was last laid on the lattice. `fraction` and the
    /// relaxation rates are a function of these positions, not of the current ones: a checkpoint
    /// keeps them.
    std::vector<double> x, y;
    std::vector<CellPatch> patches;  ///< per cell; derived
};

/// Recomputes fraction and relaxation rates from the current outlines, from scratch. Allocates.
template <class Real>
void rebuild_viscosity(const ViscosityModel& model, const Suspension& cells,
                       InteriorState& interior, Relaxation<Real>& relaxation);

/// The same from the positions kept in `interior.x`, `interior.y`: after reading a checkpoint.
/// Allocates.
template <class Real>
void restore_viscosity(const ViscosityModel& model, const Suspension& cells,
                       InteriorState& interior, Relaxation<Real>& relaxation);

/// After the membranes moved, lays anew the cells of which a node has moved by more than
/// refresh_distance since they were last laid. Team function, by cells.
void lay_cytoplasm(const ViscosityModel& model, const Suspension& cells, InteriorState& interior);

/// Brings fraction and relaxation rates up to date with the cells laid anew: touches only sites
/// whose fraction changed. Gives the same bits as `restore_viscosity` from the same kept positions.
/// Team function, by rows, once all cells are laid.
template <class Real>
void update_viscosity(const ViscosityModel& model, InteriorState& interior,
                      Relaxation<Real>& relaxation);

}  // namespace tt
