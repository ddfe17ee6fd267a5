#pragma once

namespace tt {

/// How a delta kernel and the lattice smear a membrane, in sites: the constants of the jump
/// correction (coupling/jump.hpp), measured on straight membranes on the lattice, at all positions
/// and in several directions, with Λ = 3/16 (StraightMembrane, tests/physics). They do not depend
/// on the viscosities.
struct KernelSpread {
    double force;      ///< c_f: velocity error of a node, per tangential load and mean fluidity
    double viscosity;  ///< c_φ of a membrane along the lattice: slip, per load and fluidity jump
    double turn;       ///< c_φ = viscosity − turn · t_x² t_y² in direction t
    double share;      ///< error of the shear rate at a node, per load and fluidity jump
    double square;  ///< and per dipole and mean fluidity; ∫ δ² in the limit of a fine lattice

    constexpr double slip(double tx, double ty) const {
        return viscosity - turn * tx * tx * ty * ty;
    }
};

}  // namespace tt
