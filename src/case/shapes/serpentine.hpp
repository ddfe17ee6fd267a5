#pragma once

#include <cstdint>

#include "case/shapes/drawing.hpp"

namespace tt {

/// Legs along x, one above the other, joined by half circles.
struct SerpentineShape {
    static constexpr std::string_view name = "serpentine";
    Length width;
    Length leg_length;
    Length radius;           ///< of the middle line where it turns
    std::int64_t turns = 4;  ///< half circles

    static std::vector<std::string_view> ports() { return {"inlet", "outlet"}; }
    ShapeFaults faults() const;
    ShapeDrawing drawing() const;
    friend bool operator==(const SerpentineShape&, const SerpentineShape&) = default;
};

template <>
struct FieldList<SerpentineShape> {
    using T = SerpentineShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"width", &T::width, "of the channel", channel_size, {}, "20 um"},
        FieldEntry{
            "leg_length", &T::leg_length, "of each straight piece", channel_size, {}, "80 um"},
        FieldEntry{
            "radius", &T::radius, "of the middle line where it turns", channel_size, {}, "20 um"},
        FieldEntry{"turns", &T::turns, "half circles", Range{1.0, 50.0}, {}, "4"},
    };
};

}  // namespace tt
