#pragma once

#include "verify/experiment.hpp"

namespace tt {

/// Steady tank-treading of a neo-Hookean circle with E_b/(E_s a²) = 0.0019 between walls 10 a
/// apart, periodic length 40 a.
struct TankTreading {
    double taylor = 0.0;  ///< D of the inertia ellipse
    double inclination_deg = 0.0;
    double strain = 0.0;  ///< λ_C − 1
    double period = 0.0;  ///< tank-treading period × shear rate
};

/// The spectral boundary-integral solution at G = 0.2 and viscosity ratio 1 or 5: rows of
/// tests/reference/capsule_shear_channel40.csv, to which a test holds these numbers.
TankTreading exact_tank_treading(int viscosity_ratio);

/// The case of cases/03-cell-in-shear at h = a/8, as `run` would compute it, at k t =
/// `until_strain`.
Case capsule_case(int viscosity_ratio);
TankTreading tank_treading(const Case& c, double until_strain);

/// An ellipse in simple shear whose membrane resists bending so much that it hardly deforms; the
/// same viscosity inside and outside. How much it does deform is proportional to the shear rate,
/// which `reynolds` = k a²/ν sets (the steady flow is one of Stokes at any).
struct StiffEllipse {
    double half_length = 6.0;  ///< a: semi-axis along the flow at the start [sites]
    double axis_ratio = 2.0;
    double box = 72.0;  ///< side of the box, walls apart [sites]
    double reynolds = 0.2;
};

/// Half a turn: k T/2 in which the long axis goes from 0° to −180°, over Jeffery's π (r + 1/r), and
/// how far the shape strayed.
struct JefferyOrbit {
    double period_ratio = 0.0;
    double least_axis_ratio = 0.0, most_axis_ratio = 0.0;
};
JefferyOrbit jeffery_orbit(const StiffEllipse& scene);

/// The period ratio of an ellipse of 2:1 extrapolated to a rigid one (linear in the shear rate) in
/// unbounded flow (second order in a/H).
double jeffery_period_ratio_of_rigid_ellipse();

}  // namespace tt
