#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"

namespace tt {

// What acts between cells: see case/schema.hpp.

inline constexpr Range contact_range{1e-9, 1e-3};

template <>
struct FieldList<MorseContact> {
    using T = MorseContact;
    static constexpr auto entries = std::tuple{
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
    };
};

template <>
struct FieldList<ContactPairCase> {
    using T = ContactPairCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"kinds", &T::kinds, "names of the two, or twice the same", any_value, "",
                   "[\"white\", \"red\"]"},
        FieldEntry{"zero_force_distance",
                   &T::zero_force_distance,
                   "r0 between them; auto: that of [contact]",
                   Range{1e-9, 1e-4},
                   {},
                   "0.3 um"},
        FieldEntry{
            "decay", &T::decay, "beta of Eq. 16 between them", Range{1e3, 1e10}, {}, "3.84 /um"},
        FieldEntry{"energy",
                   &T::energy,
                   "D_e between them; 0 where nothing attracts or repels",
                   Range{0.0, 1.0},
                   {},
                   "0 J/m^2"},
    };
};

template <>
struct FieldList<ContactCase> {
    using T = ContactCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"model", &T::model, "force between two cells (Eqs. 16, 17)"},
        FieldEntry{"nearest", &T::nearest,
                   "distance to the nearest node or to the nearest point of a segment"},
        FieldEntry{"short_range_repulsion",
                   &T::short_range_repulsion,
                   "an extra repulsion of very small gaps; every time it acts is counted; auto: "
                   "between walls that are not straight",
                   any_value,
                   {},
                   "true"},
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
        FieldEntry{"pair", &T::pairs, "what is different between cells of two kinds"},
    };
};

}  // namespace tt
