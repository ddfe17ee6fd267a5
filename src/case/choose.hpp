#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace tt {

/// One reason for a time step no larger than `step`.
struct StepLimit {
    std::string name;    ///< "Reynolds number", "Mach number", …
    Time step;           ///< largest Δt it allows
    std::string reason;  ///< one line with the numbers
};

/// What the case leaves open, decided: the answer to "which dx, dt, τ?". SI.
struct Choice {
    int nx = 0, ny = 0;
    Length dx;
    Time dt;
    double relaxation_time = 1.0;        ///< τ of the plasma
    double density_scale = 1.0;          ///< S
    double node_spacing = 1.0;           ///< in sites
    std::string equilibrium;             ///< linear | incompressible | full
    Rate shear_rate;                     ///< nominal k, or pseudo-shear rate
    Velocity largest_speed;              ///< expected of the undisturbed flow
    PressureGradient pressure_gradient;  ///< of the plasma-only estimate 12 μ U / H²
    Pressure area_stiffness;             ///< k_p
    std::vector<StepLimit> limits;  ///< sorted, the tightest first; dt follows the first unless the
                                    ///< case says otherwise

    double cell_reynolds(const Case& c) const;  ///< S ρ k a² / μ: as run
};

/// Limits that `auto` keeps (docs/theory/time-step.md).
inline constexpr double auto_relaxation_time = 1.5;
inline constexpr double auto_cell_reynolds = 0.3;
inline constexpr double auto_mach = 0.1;
inline constexpr double auto_tension_step_number = 0.5;
inline constexpr double auto_area_step_number = 5.0;

/// Length of the cells that a case describes: radius of the circle of the stress-free area.
Length equivalent_radius(const Case& c);

/// Decides grid, time step, relaxation time and density scale. Whatever the case states is kept; of
/// Δt, τ and S the third follows from two by ν = μ/(S ρ) = (τ − ½)/3 · Δx²/Δt. Throws CaseError
/// where the statements contradict.
Choice choose(const Case& c);

}  // namespace tt
