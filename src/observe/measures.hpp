#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/field_list.hpp"
#include "base/quantity.hpp"

namespace tt {

/// What is measured of one cell at one time, SI. One row of cells.csv.
struct CellMeasures {
    Time time;
    std::int64_t cell = 0, kind = 0;
    Length x, y;        ///< centroid; x unwrapped
    Velocity velocity;  ///< of the centroid, along x
    Area area;
    Length perimeter;
    double lambda_C = 1.0;         ///< perimeter / rest perimeter
    double strain = 0.0;           ///< ε = λ_C − 1 (Eq. 21)
    double taylor_inertia = 0.0;   ///< (L − B)/(L + B) of the inertia-equivalent ellipse
    double taylor_extent = 0.0;    ///< the same of the largest and smallest radius
    double inclination_deg = 0.0;  ///< of the long axis to the flow, −90 … 90
    double phase = 0.0;            ///< tank-treading phase [rad], accumulated
    Rate phase_rate;               ///< mean over nodes of (r × v)/r²; period = 2π / |its mean|
    double stretch_min = 1.0, stretch_max = 1.0;  ///< of the segments
    double turn_max_deg = 0.0;                    ///< largest turn between neighbouring segments
    double curvature_radius_sites = 0.0;          ///< smallest radius of curvature, in sites
    double area_error = 0.0;                      ///< A / A_ref − 1
    Length wall_distance;                         ///< smallest node to wall
    Pressure stress_traction;   ///< largest shear traction of the outer plasma on the membrane
    Pressure stress_principal;  ///< largest principal shear rate × local viscosity at the membrane
    double shear_number_star_traction = 0.0;  ///< G* = τ_max L_C / E_s (Eq. 24) with each
    double shear_number_star_principal = 0.0;
    Power dissipation;  ///< of the membrane's viscosity, per depth
};

/// What is measured of the whole run at one time, SI. One row of series.csv.
struct RunMeasures {
    Time time;
    std::int64_t step = 0;
    Velocity mean_velocity;
    Rate pseudo_shear_rate;              ///< mean velocity / width
    KinematicViscosity flux;             ///< Q per unit depth, m²/s
    PressureGradient pressure_gradient;  ///< −dp/dx acting
    Viscosity mu_app;                    ///< Eq. 22; in shear: wall stress / shear rate
    double mu_rel = 1.0;                 ///< Eq. 23
    Pressure wall_shear_stress;          ///< from the velocity gradient at both walls
    Pressure balance_shear_stress;  ///< the same from the balance of momentum, equal once steady
    double hematocrit_tube = 0.0;
    double hematocrit_discharge = 0.0;
    double lambda_C = 1.0, lambda_C_sd = 0.0;  ///< mean and standard deviation over cells
    double strain = 0.0;
    double taylor_inertia = 0.0, taylor_extent = 0.0;  ///< means over cells
    double inclination_deg = 0.0;  ///< the same, the upper half of a channel mirrored
    double area_error_max = 0.0;
    double turn_max_deg = 0.0;            ///< largest of all cells
    double curvature_radius_sites = 0.0;  ///< smallest of all cells
    // Cell-free layer, each definition by its name, per side and mean of both
    // (docs/theory/analysis.md).
    Length cfl_gap_bottom, cfl_gap_top, cfl_gap;                 ///< smallest distance to the wall
    Length cfl_envelope_bottom, cfl_envelope_top, cfl_envelope;  ///< mean over x, first membrane
    Length cfl_profile_bottom, cfl_profile_top, cfl_profile;     ///< to half of the maximum of H(y)
    Length cfl_core_bottom, cfl_core_top, cfl_core;              ///< beside a core of uniform max H
    double mach = 0.0;                                           ///< largest speed / sound speed
    std::int64_t overlaps = 0;                                   ///< nodes inside another cell
    std::int64_t repulsion_count = 0;
    Length smallest_gap;  ///< between cells; NaN where none is within the reach of contact
};

template <>
struct FieldList<CellMeasures> {
    using C = CellMeasures;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &C::time, "time"},
        FieldEntry{"cell", &C::cell, "number of the cell"},
        FieldEntry{"kind", &C::kind, "number of its kind, in the order of the case, from 0"},
        FieldEntry{"x", &C::x, "centroid, unwrapped"},
        FieldEntry{"y", &C::y, "centroid, from the bottom wall"},
        FieldEntry{"velocity", &C::velocity, "velocity of the centroid along x"},
        FieldEntry{"area", &C::area, "area"},
        FieldEntry{"perimeter", &C::perimeter, "perimeter"},
        FieldEntry{"lambda_C", &C::lambda_C, "perimeter extension ratio"},
        FieldEntry{"strain", &C::strain, "circumferential strain (Eq. 21)"},
        FieldEntry{"taylor_inertia", &C::taylor_inertia,
                   "Taylor deformation of the inertia-equivalent ellipse (Eq. 18)"},
        FieldEntry{"taylor_extent", &C::taylor_extent,
                   "Taylor deformation of the largest and smallest radius"},
        FieldEntry{"inclination_deg", &C::inclination_deg,
                   "angle of the long axis to the flow, degrees"},
        FieldEntry{"phase", &C::phase, "tank-treading phase, radians"},
        FieldEntry{"phase_rate", &C::phase_rate, "rate of the tank-treading phase"},
        FieldEntry{"stretch_min", &C::stretch_min, "smallest local stretch"},
        FieldEntry{"stretch_max", &C::stretch_max, "largest local stretch"},
        FieldEntry{"turn_max_deg", &C::turn_max_deg,
                   "largest turn between neighbouring segments, degrees"},
        FieldEntry{"curvature_radius_sites", &C::curvature_radius_sites,
                   "smallest radius of curvature of the membrane, in sites"},
        FieldEntry{"area_error", &C::area_error, "area / reference area - 1"},
        FieldEntry{"wall_distance", &C::wall_distance, "smallest distance of a node to a wall"},
        FieldEntry{"stress_traction", &C::stress_traction,
                   "largest shear traction of the outer plasma on the membrane"},
        FieldEntry{"stress_principal", &C::stress_principal,
                   "largest principal shear rate times local viscosity"},
        FieldEntry{"shear_number_star_traction", &C::shear_number_star_traction,
                   "G* (Eq. 24) by the outer traction"},
        FieldEntry{"shear_number_star_principal", &C::shear_number_star_principal,
                   "G* (Eq. 24) by the principal shear"},
        FieldEntry{"membrane_dissipation", &C::dissipation,
                   "power that the viscosity of the membrane takes, per depth"},
    };
};

template <>
struct FieldList<RunMeasures> {
    using R = RunMeasures;
    static constexpr auto entries = std::tuple{
        FieldEntry{"time", &R::time, "time"},
        FieldEntry{"step", &R::step, "time step"},
        FieldEntry{"mean_velocity", &R::mean_velocity, "mean velocity along the channel"},
        FieldEntry{"pseudo_shear_rate", &R::pseudo_shear_rate, "mean velocity / width"},
        FieldEntry{"flux", &R::flux, "volume flux per unit depth"},
        FieldEntry{"pressure_gradient", &R::pressure_gradient,
                   "pressure gradient that drives the flow"},
        FieldEntry{"mu_app", &R::mu_app, "apparent viscosity (Eq. 22)"},
        FieldEntry{"mu_rel", &R::mu_rel, "apparent viscosity / plasma viscosity (Eq. 23)"},
        FieldEntry{"wall_shear_stress", &R::wall_shear_stress, "shear stress on the walls"},
        FieldEntry{"balance_shear_stress", &R::balance_shear_stress,
                   "the same from the balance of momentum; equal once the flow is steady"},
        FieldEntry{"hematocrit_tube", &R::hematocrit_tube, "area of the cells / area of the box"},
        FieldEntry{"hematocrit_discharge", &R::hematocrit_discharge,
                   "flux of cells / flux of blood"},
        FieldEntry{"lambda_C", &R::lambda_C, "perimeter extension ratio, mean over cells"},
        FieldEntry{"lambda_C_sd", &R::lambda_C_sd, "its standard deviation over cells"},
        FieldEntry{"strain", &R::strain, "circumferential strain, mean over cells"},
        FieldEntry{"taylor_inertia", &R::taylor_inertia,
                   "Taylor deformation (inertia), mean over cells"},
        FieldEntry{"taylor_extent", &R::taylor_extent,
                   "Taylor deformation (radii), mean over cells"},
        FieldEntry{"inclination_deg", &R::inclination_deg,
                   "inclination, mean over cells, the upper half of a channel mirrored, degrees"},
        FieldEntry{"area_error_max", &R::area_error_max, "largest relative area error of any cell"},
        FieldEntry{"turn_max_deg", &R::turn_max_deg,
                   "largest turn between neighbouring segments of any cell, degrees"},
        FieldEntry{"curvature_radius_sites", &R::curvature_radius_sites,
                   "smallest radius of curvature of any membrane, in sites"},
        FieldEntry{"cfl_gap_bottom", &R::cfl_gap_bottom,
                   "smallest distance of any membrane to the bottom wall"},
        FieldEntry{"cfl_gap_top", &R::cfl_gap_top,
                   "smallest distance of any membrane to the top wall"},
        FieldEntry{"cfl_gap", &R::cfl_gap, "mean of both sides"},
        FieldEntry{"cfl_envelope_bottom", &R::cfl_envelope_bottom,
                   "mean over x of the bottom wall to the outermost membrane"},
        FieldEntry{"cfl_envelope_top", &R::cfl_envelope_top,
                   "mean over x of the top wall to the outermost membrane"},
        FieldEntry{"cfl_envelope", &R::cfl_envelope, "mean of both sides"},
        FieldEntry{"cfl_profile_bottom", &R::cfl_profile_bottom,
                   "bottom wall to where H(y) reaches half its maximum"},
        FieldEntry{"cfl_profile_top", &R::cfl_profile_top,
                   "top wall to where H(y) reaches half its maximum"},
        FieldEntry{"cfl_profile", &R::cfl_profile, "mean of both sides"},
        FieldEntry{"cfl_core_bottom", &R::cfl_core_bottom,
                   "bottom wall to a uniform core of the peak hematocrit that holds all cells"},
        FieldEntry{"cfl_core_top", &R::cfl_core_top, "top wall to that core"},
        FieldEntry{"cfl_core", &R::cfl_core, "mean of both sides"},
        FieldEntry{"mach", &R::mach, "largest speed / speed of sound"},
        FieldEntry{"overlaps", &R::overlaps, "nodes found inside another cell"},
        FieldEntry{"repulsion_count", &R::repulsion_count,
                   "node-steps with short-range repulsion since the start"},
        FieldEntry{"smallest_gap", &R::smallest_gap,
                   "smallest gap between two cells within the reach of contact"},
    };
};

/// What a column of these rows means; empty if it is none of theirs.
template <class Row>
std::string meaning_of(std::string_view key) {
    std::string meaning;
    for_each_field<Row>([&](const auto& entry) {
        if (entry.key == key) meaning = entry.meaning;
    });
    return meaning;
}

/// Velocity and hematocrit across the channel at one time, or averaged; index = row of sites from
/// the bottom.
struct Profiles {
    std::vector<double> velocity;    ///< mean over x of u_x [m/s]
    std::vector<double> hematocrit;  ///< mean over x of the cytoplasm fraction (sharp)
};

}  // namespace tt
