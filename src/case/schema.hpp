#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"

namespace tt {

// One list per table of the case file. From these lists alone come parsing, range faults, faults of
// unknown keys, unit conversion, the reference of keys (docs/keys.md) and the echo in
// resolved.toml. A field whose default lies outside its own range must be given by the user. Ranges
// are wide, but finite: no product of numbers within them overflows, and each end of each is tried
// (tests/app/ranges.py).

inline constexpr Range box_size{1e-7, 1e-1};
inline constexpr Range fluid_viscosity{1e-6, 1e3};
inline constexpr Range shear_rates{-1e6, 1e6};
inline constexpr Range contact_range{1e-9, 1e-3};

template <>
struct FieldList<DomainCase> {
    using T = DomainCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"length",
                   &T::length,
                   "along the flow; what leaves at one end re-enters at the other",
                   box_size,
                   {},
                   "80 um"},
        FieldEntry{"width", &T::width, "from wall to wall, across the flow", box_size, {}, "20 um"},
        FieldEntry{"sides", &T::sides, "what bounds the box across the flow", any_value,
                   "walls|periodic"},
    };
};

template <>
struct FieldList<FlowCase> {
    using T = FlowCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"drive", &T::drive,
                   "what drives the flow: a pressure drop along it, a body force, walls that move, "
                   "or nothing",
                   any_value, "none|pressure|body-force|shear"},
        FieldEntry{"pseudo_shear_rate",
                   &T::pseudo_shear_rate,
                   "mean velocity / width, for pressure and body-force; this key or one of the "
                   "next five, all of plasma alone; negative: flow to the left",
                   shear_rates,
                   {},
                   "500 /s"},
        FieldEntry{"mean_velocity",
                   &T::mean_velocity,
                   "over the width",
                   Range{-100.0, 100.0},
                   {},
                   "10 mm/s"},
        FieldEntry{"largest_velocity",
                   &T::largest_velocity,
                   "in the middle, 3/2 of the mean",
                   Range{-100.0, 100.0},
                   {},
                   "15 mm/s"},
        FieldEntry{"flow_rate",
                   &T::flow_rate,
                   "per depth: mean velocity * width",
                   Range{-1.0, 1.0},
                   {},
                   "0.2 mm^2/s"},
        FieldEntry{"wall_stress",
                   &T::wall_stress,
                   "shear stress on the walls, 6 mu U / H",
                   Range{-1e6, 1e6},
                   {},
                   "3.6 Pa"},
        FieldEntry{"pressure_gradient",
                   &T::pressure_gradient,
                   "pressure drop per length, 12 mu U / H^2",
                   Range{-1e12, 1e12},
                   {},
                   "360 kPa/m"},
        FieldEntry{
            "hold", &T::hold,
            "what stays constant: the pressure drop that gives plasma alone this pseudo_shear_rate "
            "(12 mu U / H^2), or the mean velocity itself, by a controller",
            any_value, "pressure-drop|mean-velocity"},
        FieldEntry{"start", &T::start, "the fluid at time zero: the flow without cells, or at rest",
                   any_value, "developed|rest"},
        FieldEntry{"shear_rate",
                   &T::shear_rate,
                   "k, for shear: the walls move with +- k * width / 2; negative: the other way",
                   shear_rates,
                   {},
                   "75 /s"},
        FieldEntry{"shear_number",
                   &T::shear_number,
                   "G = mu k a / E_s (Eq. 19), instead of shear_rate",
                   Range{1e-6, 30.0},
                   {},
                   "0.2"},
    };
};

template <>
struct FieldList<PlasmaCase> {
    using T = PlasmaCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"viscosity",
                   &T::viscosity,
                   "dynamic viscosity of the plasma",
                   fluid_viscosity,
                   {},
                   "1.2 cP"},
        FieldEntry{"density",
                   &T::density,
                   "density of plasma and cytoplasm",
                   Range{1.0, 1e5},
                   {},
                   "1025 kg/m^3"},
    };
};

template <>
struct FieldList<LayerCase> {
    using T = LayerCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"thickness", &T::thickness, "from the bottom wall up", box_size, {}, "5 um"},
        FieldEntry{
            "viscosity", &T::viscosity, "its dynamic viscosity", fluid_viscosity, {}, "6 cP"},
    };
};

template <>
struct FieldList<CellsCase> {
    using T = CellsCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"count", &T::count, "how many", Range{1.0, 1e6}, {}, "12"},
        FieldEntry{"hematocrit",
                   &T::hematocrit,
                   "area of the cells / area of the box, instead of count",
                   Range{0.0, 0.9, true, false},
                   {},
                   "38 %"},
        FieldEntry{"shape", &T::shape, "stress-free shape", any_value,
                   "circle|ellipse|biconcave|file"},
        FieldEntry{"radius",
                   &T::radius,
                   "of the circle, of the circle of the same area, or R0 of the biconcave disk",
                   Range{smallest_radius, 1e-3},
                   {},
                   "4 um"},
        FieldEntry{"aspect_ratio",
                   &T::aspect_ratio,
                   "of shape ellipse: long / short axis",
                   Range{1.0, 20.0},
                   {},
                   "1.5"},
        FieldEntry{"file",
                   &T::file,
                   "of shape file: the points of the outline, x,y in um, one a line; relative to "
                   "the case file",
                   any_value,
                   {},
                   "outline.csv"},
        FieldEntry{"pixel",
                   &T::pixel,
                   "of shape file: the unit of its numbers, as the side of a pixel; else 1 um",
                   Range{1e-10, 1.0},
                   {},
                   "0.1 um"},
        FieldEntry{"y_down",
                   &T::y_down,
                   "of shape file: its y counts downwards, as in images; auto: upwards",
                   any_value,
                   {},
                   "true"},
        FieldEntry{"smoothing",
                   &T::smoothing,
                   "of shape file: rounds corners over this length along the outline (standard "
                   "deviation of a Gaussian), as of pixels; keeps the area",
                   Range{1e-9, 1e-4},
                   {},
                   "0.15 um"},
        FieldEntry{"layout", &T::layout,
                   "where they start: one in the middle, two rows as in the paper, at random, or "
                   "at positions",
                   any_value, "single|paper|random|explicit"},
        FieldEntry{"positions",
                   &T::positions,
                   "of layout explicit: the centre of each cell",
                   Range{-0.1, 0.1},
                   {},
                   "[[\"20 um\", \"10 um\"], [\"60 um\", \"10 um\"]]"},
        FieldEntry{"angle",
                   &T::angle,
                   "by which each is turned at the start, counter-clockwise",
                   any_value,
                   {},
                   "30 deg"},
        FieldEntry{"initial_stretch",
                   &T::initial_stretch,
                   "start as an ellipse of this axis ratio; the stress-free shape stays",
                   Range{1.0, 5.0},
                   {},
                   "1.5"},
        FieldEntry{"perturbation",
                   &T::perturbation,
                   "of layout paper: largest random shift in x and y, which breaks the symmetry of "
                   "the two rows",
                   Range{0.0, 1e-3},
                   {},
                   "0.5 um"},
        FieldEntry{"seed", &T::seed, "of the random numbers", Range{0.0, 9e15}, {}, "1"},
        FieldEntry{"cytoplasm_viscosity",
                   &T::cytoplasm_viscosity,
                   "dynamic viscosity inside",
                   fluid_viscosity,
                   {},
                   "6 cP"},
    };
};

template <>
struct FieldList<HardeningCase> {
    using T = HardeningCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"apply_to", &T::apply_to,
                   "which moduli it scales (Table 1 of the paper): [] is Case I, [\"shear\"] Case "
                   "II, all four Case III",
                   any_value, "shear|bending|area|contact", "[\"shear\"]"},
        FieldEntry{
            "form", &T::form,
            "of alpha(stretch), the two repairs of Eq. 12: 1 + D (e^(beta (stretch - 1)) - 1), or "
            "1 + D (e^(stretch^beta) - e)",
            any_value, "exponential|power-exponential"},
        FieldEntry{"compression", &T::compression,
                   "alpha for stretch < 1: alpha(2 - stretch), 1, or Eq. 12 as printed", any_value,
                   "symmetric|one|as-printed"},
        FieldEntry{"D", &T::D, "how much it hardens", Range{0.0, 1e3}, {}, "0.55"},
        FieldEntry{"beta", &T::beta, "how steeply", Range{0.0, 200.0, true, false}, {}, "16"},
    };
};

template <>
struct FieldList<MembraneCase> {
    using T = MembraneCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"law", &T::law, "tension as a function of stretch (Eqs. 10, 11)", any_value,
                   "neo-hookean|hookean|skalak|surface-tension"},
        FieldEntry{"shear_modulus",
                   &T::shear_modulus,
                   "E_s; gamma of the law surface-tension",
                   Range{1e-12, 1.0},
                   {},
                   "6e-3 dyn/cm"},
        FieldEntry{"area_dilation_ratio",
                   &T::area_dilation_ratio,
                   "C of the Skalak law",
                   Range{0.0, 1e6},
                   {},
                   "1"},
        FieldEntry{"bending_modulus",
                   &T::bending_modulus,
                   "E_b (Eq. 13)",
                   Range{0.0, 1e-12},
                   {},
                   "1.8e-12 dyn cm"},
        FieldEntry{"bending", &T::bending, "curvature per current or per reference length",
                   any_value, "current|reference"},
        FieldEntry{"area_stiffness",
                   &T::area_stiffness,
                   "k_p (Eq. 14): pressure per relative change of area; it only fights leakage",
                   Range{0.0, 1e9},
                   {},
                   "2 kPa"},
        FieldEntry{"hold_area", &T::hold_area,
                   "undo the leakage of cells by a normal velocity of their nodes; false: "
                   "area pressure alone"},
        FieldEntry{"hardening", &T::hardening,
                   "strain hardening, the 2D-LD model of the paper (Eq. 12)"},
    };
};

template <>
struct FieldList<ContactCase> {
    using T = ContactCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"model", &T::model, "force between two cells (Eqs. 16, 17)", any_value,
                   "none|morse"},
        FieldEntry{"nearest", &T::nearest,
                   "distance to the nearest node or to the nearest point of a segment", any_value,
                   "node|segment"},
        FieldEntry{"zero_force_distance",
                   &T::zero_force_distance,
                   "r0: attraction beyond, repulsion below",
                   Range{1e-9, 1e-4},
                   {},
                   "0.49 um"},
        FieldEntry{"decay", &T::decay, "beta of Eq. 16", Range{1e3, 1e10}, {}, "3.84 /um"},
        FieldEntry{"energy",
                   &T::energy,
                   "D_e: energy per area of the bond",
                   Range{0.0, 1.0},
                   {},
                   "1.3e-7 J/m^2"},
        FieldEntry{"range",
                   &T::range,
                   "beyond which no force is looked for; auto: 1 % of the largest attraction",
                   contact_range,
                   {},
                   "2.5 um"},
        FieldEntry{"short_range_repulsion", &T::short_range_repulsion,
                   "an extra repulsion of very small gaps; every time it acts is counted"},
        FieldEntry{"repulsion_range",
                   &T::repulsion_range,
                   "of it; auto: one site",
                   contact_range,
                   {},
                   "0.2 um"},
        FieldEntry{"repulsion_strength",
                   &T::repulsion_strength,
                   "of it: the pressure at zero gap",
                   Range{0.0, 1e9},
                   {},
                   "1 kPa"},
    };
};

template <>
struct FieldList<NumericsCase> {
    using T = NumericsCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"dx", &T::dx, "site spacing", Range{1e-9, 1e-3}, {}, "0.2 um"},
        FieldEntry{"dt", &T::dt, "time step", Range{1e-15, 1.0}, {}, "1 us"},
        FieldEntry{"relaxation_time",
                   &T::relaxation_time,
                   "tau of the plasma, in steps",
                   Range{0.5, 20.0, true, false},
                   {},
                   "1.1"},
        FieldEntry{"density_scale",
                   &T::density_scale,
                   "S: the run has S times the density, hence S times the Reynolds number, and "
                   "larger time steps",
                   Range{1.0, 1e4},
                   {},
                   "20"},
        FieldEntry{"step_tolerance",
                   &T::step_tolerance,
                   "by how much the time step that auto takes may change D, strain, lambda_C and "
                   "mu_rel; stability may ask for a shorter one",
                   Range{1e-4, 0.2},
                   {},
                   "1 %"},
        FieldEntry{"node_spacing",
                   &T::node_spacing,
                   "of the membrane, in sites",
                   Range{0.2, 2.0},
                   {},
                   "0.8"},
        FieldEntry{"collision", &T::collision, "two relaxation times, or the one of Eq. 1",
                   any_value, "trt|bgk"},
        FieldEntry{"magic",
                   &T::magic,
                   "Lambda of TRT; 3/16 puts walls exactly half-way",
                   Range{1e-3, 10.0},
                   {},
                   "0.1875"},
        FieldEntry{"equilibrium", &T::equilibrium,
                   "linear is Stokes flow; incompressible and full (Eq. 2) keep inertia; auto: "
                   "incompressible where the flow carries cells along, else linear",
                   any_value, "auto|linear|incompressible|full"},
        FieldEntry{"precision", &T::precision,
                   "of all fields of sites: single takes half the memory and traffic; membranes "
                   "are in double either way; auto: single where there are cells and "
                   "step_tolerance is 1 % or more",
                   any_value, "auto|double|single"},
        FieldEntry{
            "delta", &T::delta,
            "kernel between sites and nodes (Eq. 8 is cosine4); auto: roma3, but peskin4 where "
            "the viscosities differ by more than ten times",
            any_value, "auto|cosine4|hat2|roma3|peskin4"},
        FieldEntry{"interior", &T::interior, "how the sites inside a cell are found", any_value,
                   "scan-line|flood-fill"},
        FieldEntry{"interface_viscosity", &T::interface_viscosity,
                   "how viscosity changes across the membrane", any_value,
                   "sharp|smoothed|area-fraction"},
        FieldEntry{"viscosity_mean", &T::viscosity_mean,
                   "viscosity of a site that holds both fluids", any_value, "harmonic|arithmetic"},
        FieldEntry{"jump_correction",
                   &T::jump_correction,
                   "take off the first-order slip and velocity error that smearing a membrane "
                   "makes; auto: "
                   "where the viscosities differ by at most twenty times",
                   any_value,
                   {},
                   "true"},
        FieldEntry{"smoothing_width",
                   &T::smoothing_width,
                   "half width of that change, in sites",
                   Range{0.5, 5.0},
                   {},
                   "2"},
        FieldEntry{"fluid_only", &T::fluid_only, "leave the cells out: the plain channel"},
    };
};

template <>
struct FieldList<TimeCase> {
    using T = TimeCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"end", &T::end, "simulated time", Range{0.0, 1e6, true, false}, {}, "80 ms"},
        FieldEntry{"average_from",
                   &T::average_from,
                   "start of the averages in summary.json; auto: half of the run",
                   Range{0.0, 1e6},
                   {},
                   "40 ms"},
    };
};

template <>
struct FieldList<OutputCase> {
    using T = OutputCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"series",
                   &T::series,
                   "between two rows of series.csv and cells.csv; auto: end / 500",
                   positive,
                   {},
                   "0.1 ms"},
        FieldEntry{"frames",
                   &T::frames,
                   "between two frames of frames.h5; auto: end / 50",
                   positive,
                   {},
                   "1 ms"},
        FieldEntry{
            "fields", &T::fields,
            "between two frames that hold velocity, pressure and cytoplasm too; auto: all do",
            positive, "never", "10 ms"},
        FieldEntry{
            "compress", &T::compress,
            "deflate frames.h5: smaller by some 40 %, at 5 to 10 times the time to write it"},
        FieldEntry{"checkpoint",
                   &T::checkpoint,
                   "between two checkpoints, in time on the clock on the wall",
                   Range{6.0, 6e6},
                   {},
                   "5 min"},
        FieldEntry{"figure_times",
                   &T::figure_times,
                   "of the figures of cells; none given: start, quarter, half, end",
                   Range{0.0, 1e6},
                   {},
                   "[\"0 ms\", \"40 ms\", \"80 ms\"]"},
    };
};

template <>
struct FieldList<Case> {
    using T = Case;
    static constexpr auto entries = std::tuple{
        FieldEntry{"format", &T::format, "of this file", Range{1.0, 1.0}, {}, "1"},
        FieldEntry{"name",
                   &T::name,
                   "of the run and of its directory in results/; else that of the file",
                   any_value,
                   {},
                   "channel-500-LD"},
        FieldEntry{"domain", &T::domain, "the box"},
        FieldEntry{"flow", &T::flow, "what drives the flow"},
        FieldEntry{"plasma", &T::plasma, "the fluid around the cells"},
        FieldEntry{"layer", &T::layer,
                   "a second fluid along the bottom wall, without a membrane, for tests"},
        FieldEntry{"cells", &T::cells, "the red blood cells"},
        FieldEntry{"membrane", &T::membrane, "their membrane"},
        FieldEntry{"contact", &T::contact, "forces between cells"},
        FieldEntry{"numerics", &T::numerics, "how it is computed; all of it may be left out"},
        FieldEntry{"time", &T::time, "how long"},
        FieldEntry{"output", &T::output, "what is written, and how often"},
    };
};

}  // namespace tt
