#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/field_list.hpp"
#include "base/quantity.hpp"
#include "case/measured_case.hpp"
#include "geometry/loops.hpp"

namespace tt {

/// What a shape of channels between ports draws [m], and what it brings with it. Fluid is inside of
/// the loops.
struct ShapeDrawing {
    std::vector<Loop> loops;
    struct Port {
        std::string name;
        Vec2 at;  ///< a point on it
    };
    std::vector<Port> ports;
    std::vector<SectionCase> sections;
    std::vector<ForkCase> forks;
};

/// A key of a shape and what is wrong with its value.
using ShapeFaults = std::vector<std::pair<std::string_view, std::string>>;

/// A shape that draws its channels itself. A new one is a header like those beside this one, and
/// its name in the list of geometry_case.hpp.
template <class S>
concept NetworkShape = requires(const S shape) {
    { shape.drawing() } -> std::convertible_to<ShapeDrawing>;  ///< only without faults
    { shape.faults() } -> std::convertible_to<ShapeFaults>;
    { S::ports() } -> std::convertible_to<std::vector<std::string_view>>;
};

/// Of widths and lengths of channels.
inline constexpr Range channel_size{1e-6, 1e-1};

/// A section along y, or along x, between two points; flow to the right of the way is positive.
SectionCase section_between(std::string name, Vec2 from, Vec2 to);

/// Draws the walls of one channel along its middle line: straight pieces and arcs, from a point and
/// a direction on.
class ChannelPen {
public:
    ChannelPen(Vec2 start, double angle, double width);

    void go(double length);
    /// About a centre at this distance; positive: to the left.
    void turn(double angle, double radius);
    /// To this width, on both sides, within so much of the way.
    void widen(double width, double length);

    Vec2 place() const { return place_; }
    double angle() const { return angle_; }
    double width() const { return width_; }
    Vec2 ahead() const;
    Vec2 left() const;
    /// Across the channel where the pen is: flow along the way is positive.
    SectionCase section(std::string name) const;
    /// Right wall forth, left wall back.
    Loop outline() const;
    const Loop& right_wall() const { return right_; }
    const Loop& left_wall() const { return left_; }

private:
    void note();

    Vec2 place_;
    double angle_, width_;
    Loop right_, left_;
};

/// What is wrong with `lengths` of a channel before and one behind, each at least as long as wide.
void judge_ends(const std::vector<Length>& lengths, Length width, ShapeFaults& faults);

/// The point where two lines meet, each a point and an angle.
Vec2 meeting_of(Vec2 a, double angle_a, Vec2 b, double angle_b);

/// Where the walls cross or touch, if they do.
std::optional<Vec2> crossing_of(const std::vector<Loop>& loops);

/// "20 um" of a length [m], for faults.
std::string um(double length);

}  // namespace tt
