#pragma once

#include "case/shapes/drawing.hpp"

namespace tt {

/// A channel along x that parts around an island and joins again.
struct LoopShape {
    static constexpr std::string_view name = "loop";
    Length parent_width;
    std::vector<Length> branch_widths;  ///< upper, lower
    Length island_length, island_width;
    Angle angle{0.7853981633974483};  ///< at which the branches leave and come back
    std::vector<Length> lengths;      ///< before and behind

    static std::vector<std::string_view> ports() { return {"inlet", "outlet"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const LoopShape&, const LoopShape&) = default;
};

template <>
struct FieldList<LoopShape> {
    using T = LoopShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"parent_width",
                   &T::parent_width,
                   "of the channel before and behind",
                   channel_size,
                   {},
                   "20 um"},
        FieldEntry{"branch_widths", &T::branch_widths, "of the upper and the lower branch",
                   channel_size, "", "[\"14 um\", \"9.2 um\"]"},
        FieldEntry{
            "island_length", &T::island_length, "of its straight sides", channel_size, {}, "80 um"},
        FieldEntry{"island_width",
                   &T::island_width,
                   "between its straight sides",
                   channel_size,
                   {},
                   "40 um"},
        FieldEntry{"angle",
                   &T::angle,
                   "at which the branches leave and come back, to x",
                   Range{0.2, 1.31},
                   {},
                   "45 deg"},
        FieldEntry{"lengths", &T::lengths, "of the channel before and behind", channel_size, "",
                   "[\"60 um\", \"60 um\"]"},
    };
};

}  // namespace tt
