#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/choice.hpp"
#include "base/quantity.hpp"
#include "case/measured_case.hpp"
#include "case/shapes/bend.hpp"
#include "case/shapes/expansion.hpp"
#include "case/shapes/fork.hpp"
#include "case/shapes/loop.hpp"
#include "case/shapes/serpentine.hpp"
#include "case/shapes/t_junction.hpp"
#include "case/wave.hpp"
#include "geometry/loops.hpp"

namespace tt {

// [geometry]: walls that are not those of the box. case/walls_of.cpp makes loops of them.

/// A straight channel, or none at all where the sides are periodic.
struct StraightShape {
    static constexpr std::string_view name = "straight";
    friend bool operator==(const StraightShape&, const StraightShape&) = default;
};
/// A smooth narrowing from both walls in the middle of the box.
struct StenosisShape {
    static constexpr std::string_view name = "stenosis";
    Length throat;         ///< width left where it is narrowest
    Length throat_length;  ///< from where it begins to where it ends
    friend bool operator==(const StenosisShape&, const StenosisShape&) = default;
};
/// Round posts in columns and rows.
struct PostsShape {
    static constexpr std::string_view name = "posts";
    Length diameter;
    std::int64_t columns = 1, rows = 1;  ///< evenly over length and width
    double row_shift = 0.0;  ///< of each column against the one before, in spacings of rows
    friend bool operator==(const PostsShape&, const PostsShape&) = default;
};
/// Whether fluid is inside or outside of what is drawn, or where a picture is bright or dark.
enum class Side : std::uint8_t { inside, outside, bright, dark };
template <>
inline constexpr auto words_of<Side> = std::to_array<std::string_view>({"inside", "outside",
                                                                        "bright", "dark"});
/// Loops of points, in the coordinates of the box.
struct DrawnShape {
    static constexpr std::string_view name = "file";
    std::string file;  ///< x,y in µm, loops parted by empty lines; or DXF, SVG, GDSII, PNG
    std::optional<Length> unit;        ///< of its numbers
    Side fluid = Side::inside;         ///< of the loops, by the even–odd rule
    std::optional<std::string> layer;  ///< of a drawing: the only one that is taken
    std::optional<Length> chord;       ///< how far from its curves
    std::optional<Length> pixel;       ///< of a picture: side of one
    // No keys:
    std::string bytes;        ///< the loops as text
    std::string original;     ///< what `file` holds, if that is a drawing or a picture
    std::vector<Loop> loops;  ///< [m]
    std::vector<std::pair<std::string, std::string>> found;  ///< in the drawing: label and text
    std::vector<std::string> remarks;                        ///< what the user should look at
    friend bool operator==(const DrawnShape&, const DrawnShape&) = default;
};
/// Cells that come in through a port, from a straight channel of its width.
struct FeedCase {
    std::optional<double> hematocrit;  ///< of the channel
    std::optional<Length> length;      ///< of the channel
    std::optional<std::int64_t> seed;  ///< of its start; else 1

    friend bool operator==(const FeedCase&, const FeedCase&) = default;
};
/// Where fluid goes in and out of what is drawn: [port.NAME].
struct PortCase {
    std::string name;        ///< of the table; no key
    std::vector<Length> at;  ///< [x, y], a point of the drawing on it
    // One of these; the last two into the channels, or out of them where negative.
    std::optional<Pressure> pressure;
    std::optional<KinematicViscosity> flow_rate;  ///< per depth
    std::optional<Velocity> mean_velocity;
    WaveCase waveform;  ///< of what it holds
    FeedCase feed;

    bool feeds() const { return feed.hematocrit.has_value(); }
    friend bool operator==(const PortCase&, const PortCase&) = default;
};
struct GeometryCase {
    std::variant<StraightShape, StenosisShape, PostsShape, DrawnShape, ForkShape, TJunctionShape,
                 BendShape, ExpansionShape, LoopShape, SerpentineShape>
        shape;

    bool straight() const { return std::holds_alternative<StraightShape>(shape); }
    /// Names of the ports of a shape of channels; of the others none.
    std::vector<std::string_view> port_names() const;
    /// Of the keys of such a shape.
    ShapeFaults faults() const;
    /// What a shape of channels draws; nothing of the others, and where its keys make no sense.
    std::optional<ShapeDrawing> drawing() const;
    /// The loops of channels that may have ports.
    std::vector<Loop> channels() const;
    friend bool operator==(const GeometryCase&, const GeometryCase&) = default;
};

}  // namespace tt
