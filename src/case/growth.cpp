#include "case/growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "membrane/shapes.hpp"

namespace tt {
namespace {

bool inside(const std::vector<Vec2>& polygon, Vec2 p) {
    bool odd = false;
    for (std::size_t k = 0, last = polygon.size() - 1; k < polygon.size(); last = k++) {
        const Vec2 a = polygon[k], b = polygon[last];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            odd = !odd;
    }
    return odd;
}

double reach_of(const std::vector<Vec2>& shape) {
    double reach = 0.0;
    for (const Vec2 p : shape) reach = std::max(reach, norm(p));
    return reach;
}

double reach_of(const std::vector<std::vector<Vec2>>& shapes) {
    double reach = 0.0;
    for (const auto& shape : shapes) reach = std::max(reach, reach_of(shape));
    return reach;
}

std::vector<std::vector<Vec2>> of_few_points(const std::vector<std::vector<Vec2>>& shapes) {
    std::vector<std::vector<Vec2>> coarse;
    for (const auto& shape : shapes)
        coarse.push_back(at_equal_arc_length(shape, std::min(32, static_cast<int>(shape.size()))));
    return coarse;
}

}  // namespace

Growth::Growth(const Crowd& crowd, const Room& room, double gap, std::uint64_t seed)
    : shapes_(of_few_points(crowd.shapes)),
      shape_of_(crowd.shape_of),
      box_(room.box),
      walls_(room.walls),
      gap_(gap),
      random_(seed),
      reach_(reach_of(shapes_)),
      bins_(room.box, 2.0 * reach_ + gap) {
    constexpr int patience = 10'000;  // trials for a place; what then overlaps is pressed apart
    for (const auto& shape : shapes_) reaches_.push_back(reach_of(shape));
    cells_.reserve(crowd.shape_of.size());
    outlines_.reserve(crowd.shape_of.size());
    for (int c = 0; c < crowd.count(); ++c) {
        Placement cell;
        std::vector<Vec2> outline;
        int trials = 0;
        do {
            cell = random_placement(c);
            outline = outline_of(c, cell);
        } while (!fits(c, cell, outline) && ++trials < patience);
        bins_.add(c, cell.centre);
        cells_.push_back(cell);
        outlines_.push_back(std::move(outline));
    }
}

Placement Growth::random_placement(int cell) {
    const double margin = box_.walls ? reach(cell) + gap_ : 0.0;
    const double x = random_.uniform(0.0, box_.nx);
    const double y = random_.uniform(margin, box_.ny - margin);
    return {{x, y}, random_.uniform(0.0, 2.0 * std::numbers::pi)};
}

void Growth::sweep() {
    int accepted = 0;
    for (int c = 0; c < count(); ++c) {
        Placement moved = cells_[c];
        const double dx = random_.uniform(-step_, step_), dy = random_.uniform(-step_, step_);
        moved.centre += Vec2{dx, dy};
        moved.angle += random_.uniform(-2.0, 2.0) * step_ / reach(c);
        std::vector<Vec2> outline = outline_of(c, moved);
        if (!fits(c, moved, outline)) continue;
        bins_.move(c, cells_[c].centre, moved.centre);
        cells_[c] = moved;
        outlines_[c] = std::move(outline);
        ++accepted;
    }
    step_ = std::clamp(step_ * (2 * accepted > count() ? 1.1 : 0.9), 1e-3 * reach(), reach());
}

bool Growth::grow(double factor) {
    const double before = scale_;
    const std::vector<std::vector<Vec2>> outlines = outlines_;
    scale_ = std::min(1.0, scale_ * factor);
    for (int c = 0; c < count(); ++c) outlines_[c] = outline_of(c, cells_[c]);
    for (int c = 0; c < count(); ++c) {
        if (fits(c, cells_[c], outlines_[c])) continue;
        scale_ = before;
        outlines_ = outlines;
        return false;
    }
    return true;
}

std::vector<Vec2> Growth::outline_of(int cell, const Placement& place) const {
    std::vector<Vec2> grown = shapes_[shape_of_[cell]];
    for (Vec2& p : grown) {
        const double distance = norm(p);
        p *= scale_ + 0.5 * gap_ / distance;
    }
    return placed(std::move(grown), place.angle, place.centre);
}

/// Keeps clear of the walls and of all other cells, and of their periodic images and its own.
bool Growth::fits(int self, const Placement& cell, const std::vector<Vec2>& outline) const {
    for (const Vec2 p : outline) {
        if (walls_ && walls_->distance_at(p) < 0.5 * gap_) return false;
        if (box_.walls && (p.y < 0.5 * gap_ || p.y > box_.ny - 0.5 * gap_)) return false;
    }
    if (!clear_of(self, self, cell, outline)) return false;
    return bins_.all_near(cell.centre, [&](int other) {
        return other == self || clear_of(self, other, cell, outline);
    });
}

bool Growth::clear_of(int self, int other, const Placement& cell,
                      const std::vector<Vec2>& outline) const {
    const bool itself = other == self;
    const double near = reach(self) + reach(other) + gap_;
    const Vec2 centre = itself ? cell.centre : cells_[other].centre;
    const std::vector<Vec2>& others = itself ? outline : outlines_[other];
    const Vec2 apart = centre - cell.centre;
    const Vec2 nearest{-box_.nx * std::round(apart.x / box_.nx),
                       box_.walls ? 0.0 : -box_.ny * std::round(apart.y / box_.ny)};
    // In a box that is not two cells long more than the nearest image counts.
    const auto more = [near](double period) { return static_cast<int>(near / period + 0.5); };
    const int columns = more(box_.nx), rows = box_.walls ? 0 : more(box_.ny);
    for (int row = -rows; row <= rows; ++row)
        for (int column = -columns; column <= columns; ++column) {
            if (itself && row == 0 && column == 0) continue;
            const Vec2 shift{nearest.x + column * box_.nx, nearest.y + row * box_.ny};
            const Vec2 between = apart + shift;
            if (dot(between, between) >= near * near) continue;
            if (any_inside(outline, other, others, centre, shift) ||
                any_inside(others, self, outline, cell.centre, -shift))
                return false;
        }
    return true;
}

/// Whether a point of `outline`, moved back by `shift`, lies in the outline `others` of the cell
/// `other` about `centre`.
bool Growth::any_inside(const std::vector<Vec2>& outline, int other,
                        const std::vector<Vec2>& others, Vec2 centre, Vec2 shift) const {
    const double reach = this->reach(other) + 0.5 * gap_;
    for (const Vec2 p : outline) {
        const Vec2 from_centre = Vec2{p.x - shift.x, p.y - shift.y} - centre;
        if (dot(from_centre, from_centre) < reach * reach && inside(others, centre + from_centre))
            return true;
    }
    return false;
}

}  // namespace tt
