#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"
#include "case/schema_flow.hpp"

namespace tt {

// The walls: see case/schema.hpp.

template <>
struct FieldList<StenosisShape> {
    using T = StenosisShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"throat", &T::throat, "width where it is narrowest", box_size, {}, "8 um"},
        FieldEntry{"throat_length",
                   &T::throat_length,
                   "from where the walls begin to close in, as a cosine, to where they are apart "
                   "again",
                   box_size,
                   {},
                   "60 um"},
    };
};

template <>
struct FieldList<PostsShape> {
    using T = PostsShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"diameter", &T::diameter, "of each post", box_size, {}, "14 um"},
        FieldEntry{"columns", &T::columns, "evenly over the length", Range{1.0, 1e4}, {}, "10"},
        FieldEntry{"rows", &T::rows, "evenly over the width", Range{1.0, 1e4}, {}, "2"},
        FieldEntry{"row_shift",
                   &T::row_shift,
                   "of each column against the one before, upwards, in spacings of rows",
                   Range{-0.5, 0.5},
                   {},
                   "0.1"},
    };
};

template <>
struct FieldList<DrawnShape> {
    using T = DrawnShape;
    static constexpr auto entries = std::tuple{
        FieldEntry{"file",
                   &T::file,
                   "closed loops of points, x,y one a line, parted by empty lines, from the lower "
                   "left corner of the box; or a drawing: .dxf, .svg, .gds, .png; relative to the "
                   "case file",
                   any_value,
                   {},
                   "walls.csv"},
        FieldEntry{"unit",
                   &T::unit,
                   "of its numbers; else 1 um, or what a drawing says",
                   Range{1e-10, 1.0},
                   {},
                   "1 um"},
        FieldEntry{"fluid", &T::fluid,
                   "on which side of the loops; a loop within a loop turns it round; of a picture: "
                   "where it is bright or dark"},
        FieldEntry{"layer",
                   &T::layer,
                   "of a drawing, with the channels: a name (dxf), number/datatype (gds), an id "
                   "(svg); may be left out where there is one",
                   any_value,
                   {},
                   "CHANNELS"},
        FieldEntry{"chord",
                   &T::chord,
                   "how far the straight pieces that stand for a curve may be off it; else 0.02 "
                   "um, of a picture a tenth of a pixel",
                   Range{1e-10, 1e-3},
                   {},
                   "0.02 um"},
        FieldEntry{
            "pixel", &T::pixel, "side of a pixel of a picture", Range{1e-9, 1e-3}, {}, "0.5 um"},
    };
};

template <>
struct FieldList<GeometryCase> {
    using T = GeometryCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{
            "shape", &T::shape,
            "a straight channel, one with a stenosis, posts, as drawn in a file, or channels "
            "between ports"},
    };
};

template <>
struct FieldList<FeedCase> {
    using T = FeedCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"hematocrit",
                   &T::hematocrit,
                   "of a straight channel as wide as the port, from which cells and plasma come "
                   "in; the port must hold a flow",
                   Range{0.0, 0.9, true, false},
                   {},
                   "20 %"},
        FieldEntry{"length",
                   &T::length,
                   "of that channel, whose ends are periodic; auto: ten widths, and room for some "
                   "cells",
                   box_size,
                   {},
                   "200 um"},
        FieldEntry{
            "seed", &T::seed, "of the places of its cells at the start", Range{0.0, 9e15}, {}, "1"},
    };
};

template <>
struct FieldList<PortCase> {
    using T = PortCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"at", &T::at,
                   "a point of the drawing on a straight piece of its outline along x or y: all of "
                   "this piece is the port; only where the channels are drawn in a file",
                   any_value, "", "[\"0 um\", \"10 um\"]"},
        FieldEntry{"pressure",
                   &T::pressure,
                   "on all of the port; this key or one of the next two",
                   Range{-1e7, 1e7},
                   {},
                   "100 Pa"},
        FieldEntry{"flow_rate",
                   &T::flow_rate,
                   "into the channels, per depth; negative: out of them",
                   Range{-1.0, 1.0},
                   {},
                   "0.02 mm^2/s"},
        FieldEntry{"mean_velocity",
                   &T::mean_velocity,
                   "over the port, into the channels; negative: out of them",
                   Range{-100.0, 100.0},
                   {},
                   "1 mm/s"},
        FieldEntry{"waveform", &T::waveform, "of what the port holds, in time"},
        FieldEntry{"feed", &T::feed, "cells that come in through this port"},
    };
};

}  // namespace tt
