#pragma once

#include "coupling/delta/delta.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Corrections that make the smeared membrane second order (docs/theory/interface.md).
///
/// At a membrane with tangential load f_t per length the shear stress jumps by Δσ = −f_t, and the
/// fluidity φ = 1/μ by Δφ from inside to outside. The immersed boundary smears Δσ with the delta
/// kernel and the lattice smears Δφ over a site, so that the product of the two is misplaced by
/// O(h): (i) the fluid outside slips past the fluid inside by s = −Δσ Δφ c_φ; (ii) the velocity
/// interpolated with the same kernel differs from that of the membrane by c_f Δσ φ̄ + c_φ Δφ σ̄ (+
/// the share of the cure of (i)), σ̄ the mean shear stress. c_f, c_φ are lengths of kernel and
/// lattice (KernelSpread). The cures are exact for a straight membrane: (i) a symmetric force
/// dipole d (t n + n t), d = −s/φ̄, whose velocity jump cancels the slip; (ii) the difference is
/// taken off the node velocity, with σ̄ from the interpolated shear rate.
struct JumpCorrection {
    bool active = false;
    double mean_fluidity = 0.0;  ///< φ̄ = ½ (1/μ_out + 1/μ_in)
    double fluidity_jump = 0.0;  ///< Δφ = 1/μ_out − 1/μ_in
    KernelSpread spread{};

    double mean_viscosity() const { return 1.0 / mean_fluidity; }
    /// Whether (i) is needed: not where both fluids have the same viscosity.
    bool has_dipole() const { return active && fluidity_jump != 0.0; }
};

/// For a membrane between plasma and a cytoplasm of these viscosities.
JumpCorrection jump_correction(const Delta& delta, double plasma, double cytoplasm);

/// (i): sets the dipoles of the nodes of one cell from their forces.
void set_dipoles(const JumpCorrection& jump, Suspension& cells, int cell);

/// (ii): corrects the interpolated node velocities of one cell.
void correct_velocities(const JumpCorrection& jump, Suspension& cells, int cell);

}  // namespace tt
