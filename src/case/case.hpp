#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "case/cell_outline.hpp"

namespace tt {

/// What the user asked for, in SI units, one struct per table of the case file. An empty optional
/// is "auto" or absent; `discretise` decides. Field lists (key, member, range, meaning) are in
/// case/schema.hpp.

struct DomainCase {
    Length length;                ///< along the flow, periodic
    Length width;                 ///< between the walls
    std::string sides = "walls";  ///< walls | periodic

    friend bool operator==(const DomainCase&, const DomainCase&) = default;
};

struct FlowCase {
    std::string drive = "none";             ///< none | pressure | body-force | shear
    std::optional<Rate> pseudo_shear_rate;  ///< mean velocity / width (pressure, body-force)
    // Instead of pseudo_shear_rate, of plasma alone; negative: to the left.
    std::optional<Velocity> mean_velocity;
    std::optional<Velocity> largest_velocity;
    std::optional<KinematicViscosity> flow_rate;  ///< per depth: mean velocity · width
    std::optional<Pressure> wall_stress;
    std::optional<PressureGradient> pressure_gradient;
    std::string hold = "pressure-drop";  ///< pressure-drop | mean-velocity
    std::string start = "developed";     ///< developed: the flow without cells | rest
    std::optional<Rate> shear_rate;  ///< drive = shear: walls move with ± shear_rate · width / 2
    std::optional<double> shear_number;  ///< G = μ k a / E_s (Eq. 19), instead of shear_rate

    friend bool operator==(const FlowCase&, const FlowCase&) = default;
};

struct PlasmaCase {
    Viscosity viscosity{1.2e-3};
    Density density{1025.0};

    friend bool operator==(const PlasmaCase&, const PlasmaCase&) = default;
};

/// A second fluid without a membrane: 0 ≤ y < thickness. For the two-layer tests.
struct LayerCase {
    std::optional<Length> thickness;
    std::optional<Viscosity> viscosity;

    friend bool operator==(const LayerCase&, const LayerCase&) = default;
};

/// Of a cell [m].
inline constexpr double smallest_radius = 1e-7;

struct CellsCase {
    std::optional<std::int64_t> count;
    std::optional<double> hematocrit;  ///< instead of count: Σ area / box area
    std::string shape = "circle";      ///< circle | ellipse | biconcave | file
    Length radius{4e-6};               ///< circle; biconcave: R₀
    std::optional<double>
        aspect_ratio;  ///< ellipse: major / minor semi-axis at the area of the circle
    std::optional<std::string> file;             ///< points of the outline, x,y in µm or pixels
    std::optional<Length> pixel;                 ///< side of one, if the file is in pixels
    std::optional<bool> y_down;                  ///< whether y counts downwards in the file
    std::optional<Length> smoothing;             ///< standard deviation along the outline
    std::optional<CellOutline> outline;          ///< what `file` holds; no key
    std::string layout = "single";               ///< single | paper | random | explicit
    std::vector<std::vector<Length>> positions;  ///< layout = explicit: [x, y]
    Angle angle;                                 ///< initial rotation, counter-clockwise
    std::optional<double>
        initial_stretch;  ///< start as an ellipse of this axis ratio, stress-free shape unchanged
    Length perturbation{0.5e-6};  ///< paper: largest random shift of each cell in x and y
    std::int64_t seed = 1;
    Viscosity cytoplasm_viscosity{6e-3};

    friend bool operator==(const CellsCase&, const CellsCase&) = default;
};

struct HardeningCase {
    std::vector<std::string> apply_to{"shear", "bending", "area", "contact"};
    std::string form =
        "exponential";  ///< exponential | power-exponential (the two repairs of Eq. 12)
    std::string compression = "symmetric";  ///< symmetric | one | as-printed, for stretch < 1
    double D = 0.55;
    double beta = 16.0;

    friend bool operator==(const HardeningCase&, const HardeningCase&) = default;
};

struct MembraneCase {
    std::string law = "neo-hookean";   ///< neo-hookean | hookean | skalak | surface-tension
    Tension shear_modulus{6e-6};       ///< E_s
    double area_dilation_ratio = 1.0;  ///< Skalak's C
    BendingModulus bending_modulus{1.8e-19};
    std::string bending = "current";         ///< curvature per current | reference length
    std::optional<Pressure> area_stiffness;  ///< k_p
    bool hold_area = true;
    HardeningCase hardening;

    friend bool operator==(const MembraneCase&, const MembraneCase&) = default;
};

struct ContactCase {
    std::string model = "morse";      ///< none | morse
    std::string nearest = "segment";  ///< node | segment
    Length zero_force_distance{0.49e-6};
    InverseLength decay{3.84e6};
    SurfaceEnergy energy{1.3e-7};
    std::optional<Length>
        range;  ///< query range R; auto: where the force has fallen to 1 % of its peak attraction
    bool short_range_repulsion = false;     ///< off by default; counted when on
    std::optional<Length> repulsion_range;  ///< auto: one site
    Pressure repulsion_strength{1e3};

    friend bool operator==(const ContactCase&, const ContactCase&) = default;
};

struct NumericsCase {
    std::optional<Length> dx;
    std::optional<Time> dt;
    std::optional<double> relaxation_time;  ///< τ of the plasma
    std::optional<double>
        density_scale;  ///< S: the simulation runs at S times the density (Reynolds number × S)
    double step_tolerance =
        0.01;  ///< by how much the step that `auto` takes may change D, ε, λ_C and μ_rel
    std::optional<double> node_spacing;  ///< in sites
    std::string collision = "trt";       ///< trt | bgk
    double magic = 3.0 / 16.0;           ///< Λ of TRT
    std::string equilibrium = "auto";    ///< auto | linear (Stokes) | incompressible | full (Eq. 2)
    std::string precision = "auto";      ///< auto | double | single, of what the sites hold
    std::string delta = "auto";          ///< auto | cosine4 | hat2 | roma3 | peskin4
    std::string interior = "scan-line";  ///< scan-line | flood-fill
    std::string interface_viscosity = "area-fraction";  ///< sharp | smoothed | area-fraction
    std::string viscosity_mean =
        "harmonic";  ///< harmonic | arithmetic, of a site that holds both fluids
    std::optional<bool> jump_correction;  ///< of slip and node velocity at membranes, second order
    double smoothing_width = 2.0;         ///< half width in sites
    bool fluid_only = false;              ///< cells absent: plain channel

    friend bool operator==(const NumericsCase&, const NumericsCase&) = default;
};

struct TimeCase {
    Time end;
    std::optional<Time> average_from;  ///< start of the averaging window; auto: half of the run

    friend bool operator==(const TimeCase&, const TimeCase&) = default;
};

struct OutputCase {
    std::optional<Time> series;      ///< auto: end / 500
    std::optional<Time> frames;      ///< auto: end / 50
    std::optional<Time> fields;      ///< auto: in every frame; infinite: in none
    bool compress = false;           ///< frames.h5
    Time checkpoint{300.0};          ///< wall clock
    std::vector<Time> figure_times;  ///< empty: start, a quarter, half, end

    friend bool operator==(const OutputCase&, const OutputCase&) = default;
};

struct Case {
    std::int64_t format = 1;
    std::string name;
    DomainCase domain;
    FlowCase flow;
    PlasmaCase plasma;
    LayerCase layer;
    CellsCase cells;
    MembraneCase membrane;
    ContactCase contact;
    NumericsCase numerics;
    TimeCase time;
    OutputCase output;

    friend bool operator==(const Case&, const Case&) = default;
};

}  // namespace tt
