#pragma once

#include "case/shapes/drawing.hpp"

namespace tt {

/// A channel along x with a wider piece in it, or a narrower one.
struct ExpansionShape {
    static constexpr std::string_view name = "expansion";
    Length width, wide_width, wide_length;
    Length taper_length{0.0};     ///< on either side of the wide piece; 0: a step
    std::vector<Length> lengths;  ///< before and behind

    static std::vector<std::string_view> ports() { return {"inlet", "outlet"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const ExpansionShape&, const ExpansionShape&) = default;
};

template <>
struct FieldList<ExpansionShape> {
    using T = ExpansionShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{
            "width", &T::width, "of the channel before and behind", channel_size, {}, "20 um"},
        FieldEntry{"wide_width", &T::wide_width, "of the piece between", channel_size, {}, "40 um"},
        FieldEntry{
            "wide_length", &T::wide_length, "of the piece between", channel_size, {}, "80 um"},
        FieldEntry{"taper_length",
                   &T::taper_length,
                   "over which the walls go apart, and together again; 0: at once",
                   Range{0.0, 1e-1},
                   {},
                   "10 um"},
        FieldEntry{"lengths", &T::lengths, "of the channel before and behind", channel_size, "",
                   "[\"60 um\", \"60 um\"]"},
    };
};

}  // namespace tt
