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
    double plasma = 1.0 / 6.0;                 ///< kinematic viscosity outside
    std::vector<double> cytoplasm{1.0 / 6.0};  ///< inside, of each kind of cells
    double layer_viscosity = 1.0 / 6.0;  ///< of a plain second fluid in 0 ≤ y < layer_thickness
    double layer_thickness = 0.0;
    double refresh_distance = 0.25;  ///< a cell is laid anew once a node is this far from where it
                                     ///< was laid, about as far ahead; 0: always
};

/// How cytoplasms of several viscosities share one field: each site holds Σ w f, f the fraction of
/// each kind and w = e/e₀ its weight, e what its viscosity adds to the mean (1/ν − 1/ν_plasma of
/// the harmonic one) and e₀ that of the kind for which it is largest. The mean of plasma and of
/// that kind at Σ w f is then the mean of all. With one viscosity the field is the plain fraction.
struct CytoplasmWeight {
    double viscosity = 0.0;  ///< of the kind of weight 1
    double weight = 1.0;     ///< w of the kind asked for
    double lowest = 0.0;     ///< of all weights and 0
};
CytoplasmWeight cytoplasm_weight(const ViscosityModel& model, int kind);

/// One cell's share in the fraction field, now and before the last refresh.
struct CellPatch {
    Patch now, before;
    LocalOutline local;
    bool refreshed = false;
};

/// How much cytoplasm the sites hold, and what it was made from.
struct InteriorState {
    /// Σ w f of CytoplasmWeight. Where cells overlap their shares add up; exact, so in double.
    Field<> cytoplasm;
    /// Where each node was when its cell was last laid on the lattice. `cytoplasm` and the
    /// relaxation rates are a function of these positions, not of the current ones: a checkpoint
    /// keeps them.
    std::vector<double> x, y;
    std::vector<CellPatch> patches;  ///< per cell; derived
};

/// The fraction of each site that is inside of cells, whatever their kind. Allocates.
Field<> fraction_inside(const InteriorState& interior);

/// Recomputes cytoplasm and relaxation rates from the current outlines, from scratch. Allocates.
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

/// Brings cytoplasm and relaxation rates up to date with the cells laid anew: touches only sites
/// where it changed. Gives the same bits as `restore_viscosity` from the same kept positions.
/// Team function, by rows, once all cells are laid.
template <class Real>
void update_viscosity(const ViscosityModel& model, const Suspension& cells, InteriorState& interior,
                      Relaxation<Real>& relaxation);

}  // namespace tt
