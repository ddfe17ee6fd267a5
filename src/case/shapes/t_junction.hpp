#pragma once

#include "case/shapes/drawing.hpp"

namespace tt {

/// A channel along x that ends at one along y, upwards and downwards.
struct TJunctionShape {
    static constexpr std::string_view name = "t-junction";
    Length parent_width;
    std::vector<Length> daughter_widths;  ///< upper, lower
    std::vector<Length> lengths;          ///< parent, and of both from its walls on

    static std::vector<std::string_view> ports() { return {"inlet", "upper", "lower"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const TJunctionShape&, const TJunctionShape&) = default;
};

template <>
struct FieldList<TJunctionShape> {
    using T = TJunctionShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"parent_width",
                   &T::parent_width,
                   "of the channel that parts",
                   channel_size,
                   {},
                   "20 um"},
        FieldEntry{"daughter_widths", &T::daughter_widths, "of the upper and the lower one",
                   channel_size, "", "[\"14 um\", \"9.2 um\"]"},
        FieldEntry{"lengths", &T::lengths, "of the middle lines, the parent first", channel_size,
                   "", "[\"60 um\", \"120 um\", \"120 um\"]"},
    };
};

}  // namespace tt
