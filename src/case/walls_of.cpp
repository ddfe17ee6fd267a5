#include "case/walls_of.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/openings.hpp"
#include "io/point_list.hpp"

namespace tt {
namespace {

constexpr int pieces = 240;  ///< of a curve: its chords are off by 10⁻⁴ of its radius

/// Both bumps: h(x) = b/2 (1 + cos(2π (x − x_c)/ℓ)), closed well beyond the wall.
Solid solid_of(const StenosisShape& shape, const DomainCase& box) {
    const double width = box.width.si, length = shape.throat_length.si;
    const double bump = 0.5 * (width - shape.throat.si), beyond = 0.25 * width;
    const double start = 0.5 * (box.length.si - length);
    Loop low{{start, -beyond}};
    for (int k = 0; k <= pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        low.push_back({start + share * length,
                       0.5 * bump * (1.0 - std::cos(2.0 * std::numbers::pi * share))});
    }
    low.push_back({start + length, -beyond});
    Loop high = low;
    for (Vec2& p : high) p.y = width - p.y;
    Solid solid;
    solid.loops = {low, high};
    solid.period_x = box.length.si;
    return solid;
}

Solid solid_of(const PostsShape& shape, const DomainCase& box) {
    Solid solid;
    const double across = box.length.si / static_cast<double>(shape.columns);
    const double up = box.width.si / static_cast<double>(shape.rows);
    // A polygon with the area of the circle.
    const double angle = 2.0 * std::numbers::pi / pieces;
    const double radius = 0.5 * shape.diameter.si * std::sqrt(angle / std::sin(angle));
    for (std::int64_t i = 0; i < shape.columns; ++i)
        for (std::int64_t j = 0; j < shape.rows; ++j) {
            const double shift = shape.row_shift * static_cast<double>(i);
            const Vec2 centre{(static_cast<double>(i) + 0.5) * across,
                              (static_cast<double>(j) + 0.5 + shift - std::floor(shift)) * up};
            Loop post;
            for (int k = 0; k < pieces; ++k)
                post.push_back(centre + radius * Vec2{std::cos(k * angle), std::sin(k * angle)});
            solid.loops.push_back(std::move(post));
        }
    solid.period_x = box.length.si;
    if (box.sides == Sides::periodic) solid.period_y = box.width.si;
    return solid;
}

Solid solid_of(const DrawnShape& shape, const DomainCase& box) {
    Solid solid;
    solid.loops = shape.loops;
    solid.outside = shape.fluid != Side::outside;
    solid.period_x = box.length.si;
    if (box.sides == Sides::periodic) solid.period_y = box.width.si;
    return solid;
}

Solid solid_of(const StraightShape&, const DomainCase&) { return {}; }

template <NetworkShape S>
Solid solid_of(const S& shape, const DomainCase&) {
    Solid solid;
    solid.loops = shape.drawing().loops;
    solid.outside = true;
    return solid;
}

}  // namespace

Solid solid_of(const Case& c) {
    Solid solid =
        std::visit([&](const auto& shape) { return solid_of(shape, c.domain); }, c.geometry.shape);
    if (!c.network()) return solid;
    solid.period_x = solid.period_y = 0.0;
    solid.openings = port_places(c).openings;
    return solid;
}

std::vector<Loop> read_loops(std::string_view text, const std::string& name, double unit) {
    std::vector<Loop> loops;
    std::vector<Fault> faults;
    std::string block;
    int line_number = 0, first_line = 1;  // of the file, and that of the block
    const auto finish = [&] {
        if (block.empty()) return;
        try {
            Loop loop = parse_points(block, name, first_line).points;
            for (Vec2& p : loop) p *= unit;
            if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
            if (loop.size() < 3)
                faults.push_back({name, 0, 0,
                                  fmt::format("loop {} has {} points; a loop takes three or more",
                                              loops.size() + 1, loop.size())});
            loops.push_back(std::move(loop));
        } catch (const CaseError& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
        block.clear();
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        const std::string_view line = text.substr(0, end + 1);
        text.remove_prefix(end + 1);
        ++line_number;
        if (line.find_first_not_of(" \t\r\n") == std::string_view::npos) {
            finish();
        } else {
            if (block.empty()) first_line = line_number;
            block += line;
        }
    }
    finish();
    if (loops.empty() && faults.empty())
        faults.push_back({name, 0, 0, "holds no loop; write x,y in um, one point a line"});
    if (!faults.empty()) throw CaseError(faults);
    return loops;
}

double narrowest_gap(const Walls& walls) {
    // In the middle between two walls the distance is largest and its slope, by the sites around,
    // small; in a corner it is not. Of a roof with slope 1 the gap is the sum at two neighbours,
    // one on either side of the ridge, and 1.
    constexpr double slightest =
        0.6;  // 0.5 where the ridge lies between two sites, 0.7 in a right angle
    double least = HUGE_VAL;
    const Field<double>& d = walls.distance;
    for (int j = 0; j < walls.lattice.ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i) {
            if (!walls.is_open(i, j)) continue;
            const Vec2 slope{0.5 * (d(i + 1, j) - d(i - 1, j)), 0.5 * (d(i, j + 1) - d(i, j - 1))};
            const auto ridge = [&](int di, int dj) {
                return d(i, j) >= d(i + di, j + dj) && d(i, j) >= d(i - di, j - dj);
            };
            if (norm(slope) >= slightest || !(ridge(1, 0) || ridge(0, 1))) continue;
            const bool upright = d(i, j + 1) + d(i, j - 1) < d(i + 1, j) + d(i - 1, j);
            const double there =
                upright ? std::max(d(i, j + 1), d(i, j - 1)) : std::max(d(i + 1, j), d(i - 1, j));
            least = std::min(least, d(i, j) + there + 1.0);
        }
    return least;
}

std::string description(const Walls& walls, double dx) {
    const double gap = narrowest_gap(walls), open = static_cast<double>(walls.open_sites());
    std::string text =
        fmt::format("{:.1f} % of the box is open, narrowest gap {} ({:.3g} sites), {} links",
                    100.0 * open / (static_cast<double>(walls.lattice.nx) * walls.lattice.ny),
                    rounded_text(Length{gap * dx}, 3), gap, walls.links.size());
    const WallRemarks& remarks = walls.remarks;
    if (remarks.closed > 0)
        text += fmt::format("; {} sites closed where a wall passes between two neighbours",
                            remarks.closed);
    if (remarks.pockets > 0) text += fmt::format("; {} sites in pockets closed", remarks.pockets);
    if (remarks.single > 0)
        text += fmt::format(
            "; {} links without a second site behind, where walls are taken as "
            "half-way",
            remarks.single);
    return text;
}

std::vector<std::string> faults_of(const Walls& walls, double dx) {
    std::vector<std::string> faults;
    if (walls.open_sites() == 0) {
        faults.push_back(
            "[geometry] leaves no room for fluid: nothing in the box is open; draw loops within "
            "the "
            "box, or write fluid = \"inside\" or \"outside\" the other way round");
        return faults;
    }
    if (walls.remarks.parts > 1)
        faults.push_back(fmt::format(
            "[geometry] the fluid is in {} parts that are not connected; join them, draw what is "
            "between them wider than a site ({}), or leave all but one of them out",
            walls.remarks.parts, rounded_text(Length{dx}, 3)));
    constexpr double fewest = 4.0;
    const double gap = narrowest_gap(walls);
    if (gap < fewest)
        faults.push_back(fmt::format(
            "[geometry] the narrowest gap is {:.2g} sites wide, {}; flow takes {:.0f}: write dx = "
            "\"{}\" in [numerics]",
            gap, rounded_text(Length{gap * dx}, 2), fewest,
            rounded_text(Length{gap * dx / 8.0}, 2)));
    return faults;
}

}  // namespace tt
