#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"
#include "case/schema_flow.hpp"

namespace tt {

// The cells and their membrane: see case/schema.hpp.

template <>
struct FieldList<EllipseShape> {
    using T = EllipseShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{
            "aspect_ratio", &T::aspect_ratio, "long / short axis", Range{1.0, 20.0}, {}, "1.5"},
    };
};

template <>
struct FieldList<OutlineShape> {
    using T = OutlineShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"file",
                   &T::file,
                   "the points of the outline, x,y in um, one a line; relative to "
                   "the case file",
                   any_value,
                   {},
                   "outline.csv"},
        FieldEntry{"pixel",
                   &T::pixel,
                   "the unit of its numbers, as the side of a pixel; else 1 um",
                   Range{1e-10, 1.0},
                   {},
                   "0.1 um"},
        FieldEntry{"y_down",
                   &T::y_down,
                   "its y counts downwards, as in images; auto: upwards",
                   any_value,
                   {},
                   "true"},
        FieldEntry{"smoothing",
                   &T::smoothing,
                   "rounds corners over this length along the outline (standard "
                   "deviation of a Gaussian), as of pixels; keeps the area",
                   Range{1e-9, 1e-4},
                   {},
                   "0.15 um"},
    };
};

template <>
struct FieldList<PaperRows> {
    using T = PaperRows;
    static constexpr auto entries = std::tuple{
        FieldEntry{"perturbation",
                   &T::perturbation,
                   "largest random shift in x and y, which breaks the symmetry of "
                   "the two rows",
                   Range{0.0, 1e-3},
                   {},
                   "0.5 um"},
    };
};

template <>
struct FieldList<AtPositions> {
    using T = AtPositions;
    static constexpr auto entries = std::tuple{
        FieldEntry{"positions",
                   &T::positions,
                   "the centre of each cell",
                   Range{-0.1, 0.1},
                   {},
                   "[[\"20 um\", \"10 um\"], [\"60 um\", \"10 um\"]]"},
    };
};

template <>
struct FieldList<CellTypeCase> {
    using T = CellTypeCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"shape", &T::shape, "stress-free shape"},
        FieldEntry{"radius",
                   &T::radius,
                   "of the circle, of the circle of the same area, or R0 of the biconcave disk",
                   Range{smallest_radius, 1e-3},
                   {},
                   "4 um"},
        FieldEntry{"angle",
                   &T::angle,
                   "by which each is turned at the start, counter-clockwise",
                   any_value,
                   {},
                   "30 deg"},
        FieldEntry{"initial_stretch",
                   &T::initial_stretch,
                   "start stretched to this axis ratio, along the axis that angle turns; the "
                   "stress-free shape stays",
                   Range{1.0, 5.0},
                   {},
                   "1.5"},
        FieldEntry{"cytoplasm_viscosity",
                   &T::cytoplasm_viscosity,
                   "dynamic viscosity inside",
                   fluid_viscosity,
                   {},
                   "6 cP"},
    };
};

inline constexpr Range cell_count{1.0, 1e6};

template <>
struct FieldList<CellsCase> {
    using T = CellsCase;
    static constexpr auto entries = std::tuple_cat(
        std::tuple{
            FieldEntry{"count", &T::count, "how many", cell_count, {}, "12"},
            FieldEntry{"hematocrit",
                       &T::hematocrit,
                       "area of the cells / area of the box, instead of count",
                       Range{0.0, 0.9, true, false},
                       {},
                       "38 %"},
        },
        FieldList<CellTypeCase>::entries,
        std::tuple{
            FieldEntry{"layout", &T::layout,
                       "where they start: one in the middle, two rows as in the paper, at random, "
                       "or at positions"},
            FieldEntry{"seed", &T::seed, "of the random numbers", Range{0.0, 9e15}, {}, "1"},
        });
};

template <>
struct FieldList<HardeningCase> {
    using T = HardeningCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"apply_to",
                   &T::apply_to,
                   "which moduli it scales (Table 1 of the paper): [] is Case I, [\"shear\"] Case "
                   "II, all four Case III",
                   any_value,
                   {},
                   "[\"shear\"]"},
        FieldEntry{
            "form", &T::form,
            "of alpha(stretch), the two repairs of Eq. 12: 1 + D (e^(beta (stretch - 1)) - 1), or "
            "1 + D (e^(stretch^beta) - e)"},
        FieldEntry{"compression", &T::compression,
                   "alpha for stretch < 1: alpha(2 - stretch), 1, or Eq. 12 as printed"},
        FieldEntry{"D", &T::D, "how much it hardens", Range{0.0, 1e3}, {}, "0.55"},
        FieldEntry{"beta", &T::beta, "how steeply", Range{0.0, 200.0, true, false}, {}, "16"},
    };
};

template <>
struct FieldList<MembraneCase> {
    using T = MembraneCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"rigid", &T::rigid,
                   "a body that keeps its shape, free to move and turn, in the place of a cell"},
        FieldEntry{"law", &T::law, "tension as a function of stretch (Eqs. 10, 11)"},
        FieldEntry{"shear_modulus",
                   &T::shear_modulus,
                   "E_s; gamma of the law surface-tension",
                   Range{1e-12, 1.0},
                   {},
                   "6e-3 dyn/cm"},
        FieldEntry{"bending_modulus",
                   &T::bending_modulus,
                   "E_b (Eq. 13)",
                   Range{0.0, 1e-12},
                   {},
                   "1.8e-12 dyn cm"},
        FieldEntry{"bending", &T::bending, "curvature per current or per reference length"},
        FieldEntry{"area_stiffness",
                   &T::area_stiffness,
                   "k_p (Eq. 14): pressure per relative change of area; it only fights leakage",
                   Range{0.0, 1e9},
                   {},
                   "2 kPa"},
        FieldEntry{"hold_area", &T::hold_area,
                   "undo the leakage of cells by a normal velocity of their nodes; false: "
                   "area pressure alone"},
        FieldEntry{"membrane_viscosity",
                   &T::membrane_viscosity,
                   "eta_m: tension per rate of stretching, of any law; slows start-up and recoil",
                   Range{0.0, 1e-6},
                   {},
                   "0.1 uN s/m"},
        FieldEntry{
            "bending_viscosity",
            &T::bending_viscosity,
            "eta_b: moment per rate of bending; slows tank-treading, and cells tumble sooner",
            Range{0.0, 1e-17},
            {},
            "1e-20 N m s"},
        FieldEntry{"hardening", &T::hardening,
                   "strain hardening, the 2D-LD model of the paper (Eq. 12)"},
    };
};

template <>
struct FieldList<KindCase> {
    using T = KindCase;
    /// What [cells] and [membrane] do not have.
    static constexpr auto own = std::tuple{
        FieldEntry{"name", &T::name, "of the kind, by which results and --set name it", any_value,
                   "", "stiff"},
        FieldEntry{"share",
                   &T::share,
                   "of the number of cells that count or hematocrit in [cells] asks for",
                   Range{0.0, 1.0, true, false},
                   {},
                   "10 %"},
        FieldEntry{"count", &T::count, "how many, instead of share", cell_count, {}, "3"},
        FieldEntry{"positions", &T::positions, "the centre of each, with layout = \"explicit\"",
                   Range{-0.1, 0.1}, "", "[[\"20 um\", \"10 um\"]]"},
    };
    static constexpr auto entries =
        std::tuple_cat(own, FieldList<CellTypeCase>::entries, FieldList<MembraneCase>::entries);
};

}  // namespace tt
