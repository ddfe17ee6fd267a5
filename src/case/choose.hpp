#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/step_limits.hpp"
#include "simulation/sections.hpp"
#include "simulation/undisturbed.hpp"

namespace tt {

/// By how many times the viscosities may differ where the jump at the membrane is corrected. At 20
/// runs hold, at 50 they fold (docs/theory/interface.md).
inline constexpr double largest_corrected_contrast = 20.0 * (1.0 + 1e-9);

/// Of the cells of one kind. SI.
struct KindChoice {
    double node_spacing = 1.0;      ///< in sites
    double expected_stretch = 1.0;  ///< largest of a membrane segment
    Pressure area_stiffness;        ///< k_p
};

/// What the case leaves open, decided: the answer to "which dx, dt, τ?". SI.
struct Choice {
    int nx = 0, ny = 0;
    Length dx;
    Vec2 origin;  ///< [m] of the box, in the coordinates of the drawing
    Time dt;
    double relaxation_time = 1.0;  ///< τ of the plasma
    double density_scale = 1.0;    ///< S
    Equilibrium equilibrium;
    Delta delta;
    Precision precision = Precision::fp64;
    bool jump_correction = true;
    Rate shear_rate;                     ///< nominal k, or pseudo-shear rate; negative: to the left
    Velocity largest_speed;              ///< of the undisturbed flow
    PressureGradient pressure_gradient;  ///< of the plasma-only estimate 12 μ U / H²
    std::vector<KindChoice> kinds{1};    ///< as cases_by_kind
    /// Walls of any shape and the flow of plasma between them; none of a straight channel.
    std::shared_ptr<const Walls> walls;
    std::shared_ptr<const UndisturbedFlow> undisturbed;
    std::vector<Section> sections;  ///< on the lattice
    std::vector<StepLimit> limits;  ///< sorted, the tightest first; dt follows the first unless the
                                    ///< case says otherwise

    double cell_reynolds(const Case& c) const;  ///< S ρ k a² / μ: as run

    /// By how much the time step changes D, ε, λ_C and μ_rel at most; 0 where no limit of accuracy
    /// applies.
    double expected_change() const;
};

/// Sites beyond a network on each side: what comes in through ports is left there.
inline constexpr int network_margin = 2;

Lattice lattice_of(const Case& c, const Choice& choice);

/// Length of a membrane's segments in sites: as the case says, else 1.5; 1 on a drop, whose nodes
/// nothing holds apart.
double node_spacing(const Case& c);

/// Of a grid, at most.
inline constexpr double most_sites = 1e9;

/// Throws CaseError, with what to write, if the grid has more than `most` sites; `why` ends "at
/// most … ".
void expect_sites(const Case& c, const Choice& choice, double most, const std::string& why);

/// The largest site spacing not above `most` that divides width and length into whole sites; `most`
/// itself where none within a factor of two does.
Length fitting_spacing(const Case& c, Length most);

/// Decides grid, time step, relaxation time and density scale. Whatever the case states is kept; of
/// Δt, τ and S the third follows from two by ν = μ/(S ρ) = (τ − ½)/3 · Δx²/Δt. Throws CaseError
/// where the statements contradict.
Choice choose(const Case& c);

}  // namespace tt
