#include <cmath>

#include "interaction/contact.hpp"

namespace tt {
namespace {

/// Does the outline wind around the point? Crossings of the ray to the right, half-open in y.
bool inside(const Outline& outline, Vec2 p) {
    int winding = 0;
    Vec2 a = outline[outline.size() - 1];
    for (int k = 0; k < outline.size(); ++k) {
        const Vec2 b = outline[k];
        if ((a.y <= p.y) != (b.y <= p.y)) {
            const double side = cross(b - a, p - a);
            if (b.y > a.y && side > 0.0) ++winding;
            if (b.y < a.y && side < 0.0) --winding;
        }
        a = b;
    }
    return winding != 0;
}

}  // namespace

std::vector<Overlap> find_overlaps(const Lattice& lattice, const Suspension& cells) {
    std::vector<Bounds> bounds(cells.cell_count());
    for (int c = 0; c < cells.cell_count(); ++c) bounds[c] = bounds_of(outline(cells, c), lattice);
    CellBins bins;
    bins.sort(lattice, bounds, 0.0);
    std::vector<Neighbour> neighbours;
    std::vector<Overlap> overlaps;
    for (int c = 0; c < cells.cell_count(); ++c) {
        bins.near(c, neighbours);
        for (const Neighbour& neighbour : neighbours) {
            const Bounds& box = bounds[neighbour.cell];
            const Outline other = outline(cells, neighbour.cell);
            for (int k = cells.first[c]; k < cells.first[c + 1]; ++k) {
                const Vec2 p = cells.position(k) - neighbour.shift;
                if (p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y)
                    continue;
                if (!inside(other, p)) continue;
                double depth2 = HUGE_VAL;
                for (int first = 0; first < other.size(); first += segments_at_once)
                    depth2 = std::fmin(
                        depth2, nearest_in_window(other, p, first, Nearest::segment).distance2);
                overlaps.push_back({k, c, neighbour.cell, std::sqrt(depth2)});
            }
        }
    }
    return overlaps;
}

double smallest_gap(const Lattice& lattice, Suspension cells, double reach) {
    ContactModel search;  // without a force
    search.repulsion_range = reach;
    ContactState contact;
    add_pair_forces(search, lattice, 0, cells, contact);
    return contact.smallest_gap;
}

}  // namespace tt
