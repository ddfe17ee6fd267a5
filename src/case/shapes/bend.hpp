#pragma once

#include "case/shapes/drawing.hpp"

namespace tt {

/// A channel along x that bends: by a right angle, half round, or by less and back again.
struct BendShape {
    static constexpr std::string_view name = "bend";
    Length width;
    Angle angle{1.5707963267948966};  ///< counter-clockwise
    Length radius;                    ///< of the middle line
    std::vector<Length> lengths;      ///< of the straight pieces before and behind it

    static std::vector<std::string_view> ports() { return {"inlet", "outlet"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const BendShape&, const BendShape&) = default;
};

template <>
struct FieldList<BendShape> {
    using T = BendShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"width", &T::width, "of the channel", channel_size, {}, "20 um"},
        FieldEntry{"angle",
                   &T::angle,
                   "by which it bends, counter-clockwise; where it is neither 90 nor 180 deg it "
                   "bends back to x. Of a loop: at which the branches leave",
                   Range{-3.1415927, 3.1415927},
                   {},
                   "90 deg"},
        FieldEntry{
            "radius", &T::radius, "of its middle line in the bend", channel_size, {}, "30 um"},
        FieldEntry{"lengths", &T::lengths, "of the straight pieces before and behind the bend",
                   channel_size, "", "[\"60 um\", \"60 um\"]"},
    };
};

}  // namespace tt
