#pragma once

#include "case/shapes/drawing.hpp"

namespace tt {

/// A channel along x that parts in two, each of which bends back to x before its end.
struct ForkShape {
    static constexpr std::string_view name = "fork";
    Length parent_width;
    std::vector<Length> daughter_widths;  ///< upper, lower
    std::vector<Angle> angles{Angle{0.62831853071795862},
                              Angle{-0.62831853071795862}};  ///< of the same, to x
    std::vector<Length> lengths;  ///< of the middle lines: parent, upper, lower

    static std::vector<std::string_view> ports() { return {"inlet", "upper", "lower"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const ForkShape&, const ForkShape&) = default;
};

template <>
struct FieldList<ForkShape> {
    using T = ForkShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"parent_width",
                   &T::parent_width,
                   "of the channel that parts",
                   channel_size,
                   {},
                   "20 um"},
        FieldEntry{"daughter_widths", &T::daughter_widths, "of the upper and the lower one",
                   channel_size, "", "[\"14 um\", \"9.2 um\"]"},
        FieldEntry{"angles", &T::angles,
                   "at which they leave, to x, counter-clockwise; they bend "
                   "back to x",
                   Range{-1.31, 1.31}, "", "[\"36 deg\", \"-36 deg\"]"},
        FieldEntry{
            "lengths", &T::lengths,
            "of the channels along their middle lines: parent, upper and lower one; of the other "
            "shapes before and behind",
            channel_size, "", "[\"60 um\", \"120 um\", \"120 um\"]"},
    };
};

}  // namespace tt
