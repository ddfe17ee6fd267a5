#include "case/layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/random.hpp"
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

/// Hard particles in a channel: outlines grown about their centres by a common factor.
class Packing {
public:
    Packing(const std::vector<Vec2>& shape, int count, double length, double width, double gap,
            std::uint64_t seed)
        : shape_(at_equal_arc_length(shape, std::min(32, static_cast<int>(shape.size())))),
          length_(length),
          width_(width),
          gap_(gap),
          random_(seed) {
        for (Vec2 p : shape_) reach_ = std::max(reach_, norm(p));
        cells_.resize(count);
        outlines_.resize(count);
        const double margin = scale_ * reach_ + gap_;
        for (int c = 0; c < count; ++c) {
            do {
                cells_[c] = {
                    {random_.uniform(0.0, length_), random_.uniform(margin, width_ - margin)},
                    random_.uniform(0.0, 2.0 * std::numbers::pi)};
                outlines_[c] = outline_of(cells_[c]);
            } while (!fits(c, cells_[c], outlines_[c], c));
        }
    }

    /// One trial move and turn of every cell; the step adapts so that about half are accepted.
    void sweep() {
        int accepted = 0;
        for (int c = 0; c < count(); ++c) {
            Placement moved = cells_[c];
            moved.centre += Vec2{random_.uniform(-step_, step_), random_.uniform(-step_, step_)};
            moved.angle += random_.uniform(-2.0, 2.0) * step_ / reach();
            std::vector<Vec2> outline = outline_of(moved);
            if (!fits(c, moved, outline, count())) continue;
            cells_[c] = moved;
            outlines_[c] = std::move(outline);
            ++accepted;
        }
        step_ = std::clamp(step_ * (2 * accepted > count() ? 1.1 : 0.9), 1e-3 * reach(), reach());
    }

    /// Grows all cells by `factor` (at most to full size) if none then touches another.
    bool grow(double factor) {
        const double before = scale_;
        const std::vector<std::vector<Vec2>> outlines = outlines_;
        scale_ = std::min(1.0, scale_ * factor);
        for (int c = 0; c < count(); ++c) outlines_[c] = outline_of(cells_[c]);
        for (int c = 0; c < count(); ++c) {
            if (fits(c, cells_[c], outlines_[c], c)) continue;
            scale_ = before;
            outlines_ = outlines;
            return false;
        }
        return true;
    }

    double scale() const { return scale_; }
    double reach() const { return scale_ * reach_; }
    const std::vector<Placement>& cells() const { return cells_; }

private:
    int count() const { return static_cast<int>(cells_.size()); }

    std::vector<Vec2> outline_of(const Placement& cell) const {
        std::vector<Vec2> grown = shape_;
        for (Vec2& p : grown) {
            const double distance = norm(p);
            p *= scale_ + 0.5 * gap_ / distance;
        }
        return placed(std::move(grown), cell.angle, cell.centre);
    }

    /// Keeps clear of the walls and of cells 0 … others − 1 (and their periodic images).
    bool fits(int self, const Placement& cell, const std::vector<Vec2>& outline, int others) const {
        for (Vec2 p : outline) {
            if (p.y < 0.5 * gap_ || p.y > width_ - 0.5 * gap_) return false;
        }
        const double near = 2.0 * scale_ * reach_ + gap_;
        for (int o = 0; o < others; ++o) {
            if (o == self) continue;
            Vec2 apart = cells_[o].centre - cell.centre;
            const double shift = -length_ * std::round(apart.x / length_);
            apart.x += shift;
            if (dot(apart, apart) >= near * near) continue;
            if (any_inside(outline, outlines_[o], cells_[o].centre, shift) ||
                any_inside(outlines_[o], outline, cell.centre, -shift)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a point of `outline`, moved by `shift` along x, lies in the cell `other` about
    /// `centre`.
    bool any_inside(const std::vector<Vec2>& outline, const std::vector<Vec2>& other, Vec2 centre,
                    double shift) const {
        const double reach = scale_ * reach_ + 0.5 * gap_;
        for (Vec2 p : outline) {
            const Vec2 from_centre = Vec2{p.x - shift, p.y} - centre;
            if (dot(from_centre, from_centre) < reach * reach &&
                inside(other, centre + from_centre))
                return true;
        }
        return false;
    }

    std::vector<Vec2> shape_;
    double length_, width_, gap_;
    Random random_;
    double scale_ = 0.2;
    double reach_ = 0.0;
    double step_ = 1.0;
    std::vector<Placement> cells_;
    std::vector<std::vector<Vec2>> outlines_;
};

}  // namespace

std::vector<Placement> two_rows(int count, double length, double width, double perturbation,
                                std::uint64_t seed) {
    Random random(seed);
    std::vector<Placement> cells;
    const int per_row = count / 2;
    for (int c = 0; c < count; ++c) {
        const Vec2 symmetric{(c % per_row + 0.5) * length / per_row,
                             c < per_row ? 0.25 * width : 0.75 * width};
        const double dx = random.uniform(-perturbation, perturbation);
        const double dy = random.uniform(-perturbation, perturbation);
        cells.push_back({symmetric + Vec2{dx, dy}, 0.0});
    }
    return cells;
}

std::vector<Placement> random_placements(const std::vector<Vec2>& shape, int count, double length,
                                         double width, double gap, std::uint64_t seed) {
    constexpr int patience = 4000;  // sweeps
    Packing packing(shape, count, length, width, gap, seed);
    double growth = 0.1;
    for (int sweep = 0; sweep < patience && packing.scale() < 1.0; ++sweep) {
        packing.sweep();
        growth =
            packing.grow(1.0 + growth) ? std::min(0.1, 1.2 * growth) : std::max(1e-4, 0.8 * growth);
    }
    if (packing.scale() < 1.0) {
        const double area = area_of(shape) * count / (length * width);
        throw CaseError(
            {{"", 0, 0,
              fmt::format(
                  "[cells] layout = \"random\": no room for {} cells; hematocrit {:.1f} % "
                  "was reached of {:.1f} %; write hematocrit = \"{:.0f} %\", fewer cells or "
                  "another seed",
                  count, 100.0 * area * packing.scale() * packing.scale(), 100.0 * area,
                  90.0 * area * packing.scale() * packing.scale())}});
    }
    return packing.cells();
}

}  // namespace tt
