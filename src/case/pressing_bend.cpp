#include <algorithm>
#include <cmath>

#include "case/pressing.hpp"
#include "case/turning.hpp"
#include "membrane/shapes.hpp"

// How a cell that is pressed bends, and grows anew where that is not enough.

namespace tt {
namespace {

/// The softest that cells become before they are found not to fit.
constexpr double softest = 5e-4;

}  // namespace

void Pressing::dent(int cell, const Push& push) {
    const Vec2 move = turned_back(cells_[cell].axis, push.move);
    const auto add = [&](int k, double weight) {
        dents_[k] += weight * move;
        weights_[k] += weight;
    };
    add(push.edge, 1.0 - push.along);
    add(wrapped(push.edge + 1, points_), push.along);
}

/// Bends a cell where it is pressed.
void Pressing::bend(int c) {
    Cell& cell = cells_[c];
    if (cell.bend.empty()) cell.bend.resize(points_);
    for (int k = 0; k < points_; ++k) cell.bend[k] += 0.5 / std::max(1.0, weights_[k]) * dents_[k];
    spring_back(cell.bend);
    hold_lengths(cell);
    hand_over_motion(cell);
    hold_area(cell);
}

/// Towards the shape at rest, and towards the neighbouring points.
void Pressing::spring_back(std::vector<Vec2>& bend) const {
    const double smoothing = 2.5 * std::min(spring_, 0.1);
    const Vec2 first = bend[0];
    Vec2 before = bend[points_ - 1];
    for (int k = 0; k < points_; ++k) {
        const Vec2 here = bend[k], after = k + 1 < points_ ? bend[k + 1] : first;
        bend[k] = (1.0 - spring_) * (here + smoothing * (before + after - 2.0 * here));
        before = here;
    }
}

void Pressing::hold_lengths(Cell& cell) const {
    std::vector<Vec2>& bend = cell.bend;
    const std::vector<Vec2>& shape = form_of(cell).shape;
    constexpr double share = 0.4;  // of the error, by each end
    for (int k = 0; k < points_; ++k) {
        const Vec2 edge = at(cell, k + 1) - at(cell, k);
        const double length = norm(edge);
        const double wanted = scale_of(cell) * norm(shape[wrapped(k + 1, points_)] - shape[k]);
        const Vec2 move = share * (wanted - length) / length * edge;
        bend[wrapped(k + 1, points_)] += move;
        bend[k] -= move;
    }
}

/// The part of the bend that is a motion of the whole cell.
void Pressing::hand_over_motion(Cell& cell) const {
    const std::vector<Vec2>& shape = form_of(cell).shape;
    Vec2 mean;
    for (const Vec2 p : cell.bend) mean += p / points_;
    double spin = 0.0, inertia = 0.0;
    for (int k = 0; k < points_; ++k) {
        cell.bend[k] -= mean;
        spin += cross(shape[k], cell.bend[k]);
        inertia += dot(shape[k], shape[k]);
    }
    spin /= inertia;
    for (int k = 0; k < points_; ++k) cell.bend[k] -= spin * turned_left(shape[k]);
    cell.centre += turned(cell.axis, mean);
    cell.axis = turned_on(cell.axis, 0.5 * spin / scale_of(cell));
}

void Pressing::hold_area(Cell& cell) const {
    std::vector<Vec2>& bend = cell.bend;
    double area = 0.0, length = 0.0;
    std::vector<Vec2> normals(points_);
    for (int k = 0; k < points_; ++k) {
        const Vec2 before = at(cell, k - 1), here = at(cell, k), after = at(cell, k + 1);
        area += 0.5 * cross(here, after);
        length += norm(after - here);
        normals[k] = turned_right(after - before) / norm(after - before);
    }
    const double scale = scale_of(cell);
    const double swell = (scale * scale * form_of(cell).area - area) / length;
    for (int k = 0; k < points_; ++k) bend[k] += swell * normals[k];
}

/// Rigid cells begin to bend; soft ones become twice as soft, and the gap smaller. False: they are
/// as soft as they become.
bool Pressing::soften() {
    if (spring_ == 1.0) {
        spring_ = 0.1;
        return true;
    }
    if (spring_ < softest) return false;
    spring_ *= 0.5;
    gap_ *= 0.8;
    return true;
}

/// Cells that cross each other never part, however soft: those that press become small, and grow
/// anew where they are. Nothing comes of it too often.
bool Pressing::shrink_stuck() {
    constexpr int most = 12;
    constexpr double small = 0.25;
    if (++shrunk_ > most) return false;
    for (int c = 0; c < cell_count(); ++c) {
        if (cells_[c].pressed <= tolerance * gap_) continue;
        cells_[c].size = small;
        cells_[c].bend.clear();
        draw(c);
    }
    return true;
}

/// One step of those that grow anew; false if none does.
bool Pressing::grow_anew() {
    constexpr double growth = 1.02;
    bool any = false;
    for (int c = 0; c < cell_count(); ++c) {
        Cell& cell = cells_[c];
        if (cell.size >= 1.0) continue;
        const double factor = std::min(growth, 1.0 / cell.size);
        cell.size = factor < growth ? 1.0 : cell.size * factor;
        for (Vec2& p : cell.bend) p *= factor;
        draw(c);
        any = true;
    }
    return any;
}

}  // namespace tt
