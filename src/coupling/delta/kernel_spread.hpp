#pragma once

namespace tt {

/// How wide a delta kernel φ smears a membrane, in sites, averaged over the membrane's direction
/// (which matters by less than 1 %). With H the integral of φ across a straight membrane, Θ the
/// unit step and □ the unit site box:
struct KernelSpread {
    double force;  ///< ∫ H (1 − H) dn = ½ ⟨|r − r'|⟩: force smeared, velocity averaged by the same
                   ///< kernel
    double viscosity;  ///< ∫ (Θ − H Θ*□) dn = ½ ⟨|r − b|⟩, b uniform in the site box: force
                       ///< smeared, area fraction
};

}  // namespace tt
