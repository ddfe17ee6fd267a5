#include "case/pressing.hpp"

#include <algorithm>
#include <cmath>

#include "case/turning.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

/// Largest step of a cell in one visit, in reaches of the cell, and largest turn [rad].
constexpr double longest_step = 0.1;
/// Share of the way out of a neighbour that a cell goes in one visit. Half would do for two, as the
/// neighbour goes too. In a crowd they hand the way on, and a longer step takes half the visits.
constexpr double forth = 0.8;
/// What outlines may overlap while they still grow, in thicknesses of the cell.
constexpr double growing_overlap = 0.15;
/// Share of the gap below which a cell stays.
constexpr double rest = 0.05;
/// Sweeps without growth after which cells are stuck.
constexpr int patience = 120;

/// Cut to 2⁻²⁴, so that functions of the C library that differ in their last bit give the same.
double snapped(double v) { return std::nearbyint(v * 0x1p24) * 0x1p-24; }
Vec2 snapped(Vec2 v) { return {snapped(v.x), snapped(v.y)}; }

std::vector<Vec2> coarse(const std::vector<Vec2>& shape, int count) {
    std::vector<Vec2> points = at_equal_arc_length(shape, count);
    for (Vec2& p : points) p = snapped(p);
    return points;
}

/// Largest distance of a node of `fine` to the polygon.
double largest_distance(const std::vector<Vec2>& fine, const std::vector<Vec2>& polygon) {
    double largest = 0.0;
    for (const Vec2 p : fine) {
        double least = HUGE_VAL;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec2 from = polygon[k], edge = polygon[(k + 1) % polygon.size()] - from;
            const double along = std::clamp(dot(p - from, edge) / dot(edge, edge), 0.0, 1.0);
            least = std::min(least, norm(p - from - along * edge));
        }
        largest = std::max(largest, least);
    }
    return snapped(largest);
}

}  // namespace

Pressing::Pressing(const std::vector<std::vector<Vec2>>& shapes, const Room& room, double gap)
    : box_(room.box), walls_(room.walls), points_(Edges::most), thickness_(HUGE_VAL), gap_(gap) {
    for (const auto& shape : shapes) points_ = std::min(points_, static_cast<int>(shape.size()));
    for (const auto& shape : shapes) {
        Form form;
        form.shape = coarse(shape, points_);
        form.area = area_of(form.shape);
        form.thickness = 2.0 * form.area / perimeter_of(form.shape);
        form.bulge = largest_distance(shape, form.shape);
        for (const Vec2 p : form.shape) {
            form.reach = std::max(form.reach, norm(p));
            form.gyration2 += 0.5 * dot(p, p) / points_;  // of the area, half that of the outline
        }
        reach_ = std::max(reach_, form.reach);
        bulge_ = std::max(bulge_, form.bulge);
        thickness_ = std::min(thickness_, form.thickness);
        forms_.push_back(std::move(form));
    }
    dents_.resize(points_);
    weights_.resize(points_);
}

void Pressing::add(int shape, Vec2 centre, double angle) {
    const Vec2 axis = snapped({std::cos(angle), std::sin(angle)});
    Cell cell;
    cell.form = shape;
    cell.centre = centre;
    cell.axis = axis / norm(axis);
    cells_.push_back(std::move(cell));
    for (auto* array : {&x_, &y_, &edge_x_, &edge_y_, &inverse_})
        array->resize(array->size() + points_);
    bounds_.emplace_back();
}

Edges Pressing::edges_of(int cell) const {
    const std::size_t first = static_cast<std::size_t>(cell) * points_;
    return {&x_[first], &y_[first], &edge_x_[first], &edge_y_[first], &inverse_[first], points_};
}

/// Point of the outline in the cell's own frame.
Vec2 Pressing::at(const Cell& cell, int point) const {
    const int k = wrapped(point, points_);
    const Vec2 place = scale_of(cell) * form_of(cell).shape[k];
    return cell.bend.empty() ? place : place + cell.bend[k];
}

/// Sets the outline of a cell from its place.
void Pressing::draw(int c) {
    Cell& cell = cells_[c];
    const std::size_t first = static_cast<std::size_t>(c) * points_;
    Bounds box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, true};
    cell.low = {HUGE_VAL, HUGE_VAL};
    cell.high = {-HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < points_; ++k) {
        const Vec2 own = at(cell, k);
        cell.low = {std::min(cell.low.x, own.x), std::min(cell.low.y, own.y)};
        cell.high = {std::max(cell.high.x, own.x), std::max(cell.high.y, own.y)};
        const Vec2 p = cell.centre + turned(cell.axis, own);
        x_[first + k] = p.x;
        y_[first + k] = p.y;
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    for (int k = 0; k < points_; ++k) {
        const std::size_t here = first + k, next = k + 1 < points_ ? here + 1 : first;
        const Vec2 edge{x_[next] - x_[here], y_[next] - y_[here]};
        edge_x_[here] = edge.x;
        edge_y_[here] = edge.y;
        inverse_[here] = 1.0 / dot(edge, edge);
    }
    bounds_[c] = box;
    cell.stirred = sweeps_;
}

void Pressing::scale_by(double factor) {
    scale_ *= factor;
    for (int c = 0; c < cell_count(); ++c) {
        for (Vec2& p : cells_[c].bend) p *= factor;
        draw(c);
    }
}

/// Looks at each cell in turn; returns by how much the deepest comes too near.
double Pressing::sweep() {
    bins_.sort(box_, bounds_, gap_ + 2.0 * bulge_ + 4.0 * longest_step * scale_ * reach_);
    double deepest = 0.0;
    for (int c = 0; c < cell_count(); ++c) deepest = std::max(deepest, visit(c));
    ++sweeps_;
    return deepest;
}

/// Nothing around the cell has changed since it was looked at, so nothing pressed on it then.
bool Pressing::undisturbed(int cell) const {
    std::int64_t stirred = cells_[cell].stirred;
    for (const Neighbour& other : near_) stirred = std::max(stirred, cells_[other.cell].stirred);
    return stirred < cells_[cell].visited;
}

/// Moves a cell out of the way of its neighbours.
double Pressing::visit(int c) {
    bins_.near(c, near_);
    Cell& cell = cells_[c];
    if (undisturbed(c)) return 0.0;
    cell.visited = sweeps_;
    ++visits_;
    deepest_ = 0.0;
    step_ = {};
    turn_ = 0.0;
    std::fill(dents_.begin(), dents_.end(), Vec2{});
    std::fill(weights_.begin(), weights_.end(), 0.0);
    for (const Neighbour& other : near_) {
        find_pushes(c, other.cell, other.shift);
        yield(c, forth);
    }
    if (box_.walls || walls_) {
        find_wall_pushes(c);
        yield(c, 1.0);
    }
    cell.pressed = deepest_;
    if (deepest_ < rest * gap_ && cell.bend.empty()) return deepest_;
    const double most = longest_step * scale_ * form_of(cell).reach, length = norm(step_);
    cell.centre += (length > most ? most / length : 1.0) * step_;
    cell.axis = turned_on(cell.axis, 0.5 * std::clamp(turn_, -longest_step, longest_step));
    if (spring_ < 1.0) bend(c);
    draw(c);
    return deepest_;
}

/// False where the point is too far from the box around an outline, which lies as the cell does.
bool Pressing::near_outline(int c, Vec2 point, double reach) const {
    const Cell& cell = cells_[c];
    const Vec2 own = turned_back(cell.axis, point - cell.centre);
    return own.x > cell.low.x - reach && own.x < cell.high.x + reach &&
           own.y > cell.low.y - reach && own.y < cell.high.y + reach;
}

/// Where the outlines of a cell and of another, moved by `shift`, come too near: at the nodes of
/// either.
void Pressing::find_pushes(int cell, int other, Vec2 shift) {
    const double reach = gap_ + (form_of(cells_[cell]).bulge + form_of(cells_[other]).bulge);
    const Bounds &a = bounds_[cell], &b = bounds_[other];
    const Vec2 low{std::max(a.low.x, b.low.x + shift.x) - reach,
                   std::max(a.low.y, b.low.y + shift.y) - reach};
    const Vec2 high{std::min(a.high.x, b.high.x + shift.x) + reach,
                    std::min(a.high.y, b.high.y + shift.y) + reach};
    if (low.x > high.x || low.y > high.y) return;
    const auto between = [&](Vec2 p) {
        return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
    };
    const Edges mine = edges_of(cell), others = edges_of(other);
    for (int k = 0; k < points_; ++k) {
        const Vec2 here = mine.node(k), there = others.node(k) + shift;
        if (between(here) && near_outline(other, here - shift, reach))
            if (const auto push = push_from(others, here - shift, reach))
                pushes_.push_back({k, 0.0, -push->move});
        if (between(there) && near_outline(cell, there, reach))
            if (const auto push = push_from(mine, there, reach)) pushes_.push_back(*push);
    }
}

void Pressing::find_wall_pushes(int cell) {
    const double reach = gap_ + form_of(cells_[cell]).bulge;
    const Edges mine = edges_of(cell);
    for (int k = 0; k < points_; ++k) {
        if (walls_) {
            const Vec2 here{mine.x[k], mine.y[k]};
            const double short_of = reach - walls_->distance_at(here);
            if (short_of > 0.0) pushes_.push_back({k, 0.0, short_of * walls_->away_at(here)});
            continue;
        }
        if (mine.y[k] < reach) pushes_.push_back({k, 0.0, {0.0, reach - mine.y[k]}});
        if (mine.y[k] > box_.ny - reach)
            pushes_.push_back({k, 0.0, {0.0, box_.ny - reach - mine.y[k]}});
    }
}

/// Adds to the step and turn of a cell what the pushes of one neighbour ask for: the mean of them,
/// weighted by their depth, acts on the mean of their points. A push that has an arm b about the
/// centre moves the cell by 1 / (1 + b²/k²) of it and turns it for the rest, k the radius of
/// gyration.
void Pressing::yield(int cell, double share) {
    const Edges mine = edges_of(cell);
    Vec2 move, point;
    double total = 0.0;
    for (const Push& push : pushes_) {
        const double depth = norm(push.move);
        deepest_ = std::max(deepest_, depth);
        move += depth * push.move;
        point += depth *
                 (mine.node(push.edge) + push.along * mine.edge(push.edge) - cells_[cell].centre);
        total += depth;
        if (spring_ < 1.0) dent(cell, push);
    }
    pushes_.clear();
    const double size2 = dot(move, move);
    if (!(size2 > 0.0)) return;
    const double moment = cross(point, move) / (total * total);
    const double scale = scale_of(cells_[cell]);
    const double inertia = scale * scale * form_of(cells_[cell]).gyration2;
    const double arm2 = moment * moment * total * total / size2;
    step_ += share / (1.0 + arm2 / inertia) / total * move;
    turn_ += share * moment / (inertia + arm2);
}

/// Factor of the next growth: as much overlap as may be.
double Pressing::growth_step() const {
    const double advance = std::max(growing_overlap * scale_ * thickness_, tolerance * gap_);
    return std::min(1.0 / scale_, 1.0 + advance / (scale_ * reach_));
}

bool Pressing::grow_from(double scale, const Watch& watch) {
    scale_ = scale;
    for (int c = 0; c < cell_count(); ++c) draw(c);
    for (int waited = 0;;) {
        const double deepest = sweep();
        if (watch) watch(scale_ * scale_);
        if (shrunk_ > 0 && grow_anew()) continue;
        const double allowed =
            tolerance * gap_ + (scale_ < 1.0 ? growing_overlap * scale_ * thickness_ : 0.0);
        if (deepest <= allowed) {
            if (scale_ >= 1.0) return true;
            scale_by(growth_step());
            waited = 0;
        } else if (++waited > patience) {
            if (!soften() && (scale_ < 1.0 || !shrink_stuck())) return false;
            waited = 0;
        }
    }
}

double Pressing::press(double scale, const Watch& watch) {
    if (grow_from(scale, watch)) return 1.0;
    for (int waited = patience;;) {
        if (sweep() <= tolerance * gap_) return scale_;
        if (watch) watch(scale_ * scale_);
        if (++waited < patience) continue;
        scale_by(0.995);
        waited = 0;
    }
}

std::vector<Placement> Pressing::cells() const {
    std::vector<Placement> placements;
    placements.reserve(cells_.size());
    for (const Cell& cell : cells_)
        placements.push_back({cell.centre, std::atan2(cell.axis.y, cell.axis.x), cell.bend});
    return placements;
}

}  // namespace tt
