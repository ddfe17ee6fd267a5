#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "base/parallel.hpp"
#include "interaction/contact.hpp"

// How the search is kept cheap and yet a function of the positions alone: pairs of a node and a
// cell within reach + skin are listed, with a window of segments around the nearest one and a bound
// for all others. While no node has moved by more than the skin no pair can be missing; while the
// nearest segment of the window beats the bound, less what both cells have moved, it is the nearest
// of all; where it does not, the outline is searched again.

namespace tt {
namespace {

/// How far nodes may move, beyond the common drift, before pairs are listed anew [sites]. Sets cost
/// only.
constexpr double skin = 0.3;
/// How much farther than the nearest a segment may be and still be measured for the bound [sites].
/// Sets cost only.
constexpr double horizon = 1.0;
/// Guards the comparison of distances against rounding.
constexpr double rounding = 1e-6;

/// Common motion of the cells since pairs were listed: any vector would do, the better the fewer
/// lists.
Vec2 drift_of(const Suspension& cells, const ContactState& contact) {
    Vec2 sum;
    for (int c = 0; c < cells.cell_count(); ++c) {
        const int k = cells.first[c];
        sum += cells.position(k) - Vec2{contact.listed_x[k], contact.listed_y[k]};
    }
    return sum / std::max(1, cells.cell_count());
}

TT_CLONES double largest_move2(const double* x, const double* y, const double* x0, const double* y0,
                               int count, Vec2 drift) {
    double largest = 0.0;
#pragma omp simd reduction(max : largest)
    for (int k = 0; k < count; ++k) {
        const double dx = x[k] - x0[k] - drift.x;
        const double dy = y[k] - y0[k] - drift.y;
        const double d2 = dx * dx + dy * dy;
        largest = greater(largest, d2);
    }
    return largest;
}

/// Are the lists of the state given still complete? Sets `moved` of this thread's cells; the same
/// answer on all.
bool lists_hold(const ContactModel& model, const Suspension& cells, ContactState& contact,
                Vec2& drift) {
    if (contact.listed_reach != model.reach() || contact.listed_x.size() != cells.x.size() ||
        static_cast<int>(contact.cells.size()) != cells.cell_count()) {
        team_barrier();  // all must have looked before one of them changes it
        return false;
    }
    drift = drift_of(cells, contact);
    const auto [begin, end] = team_share(cells.cell_count());
    for (int c = begin; c < end; ++c) {
        const int k = cells.first[c];
        contact.cells[c].moved =
            std::sqrt(largest_move2(&cells.x[k], &cells.y[k], &contact.listed_x[k],
                                    &contact.listed_y[k], cells.node_count(c), drift));
    }
    team_barrier();
    return std::all_of(contact.cells.begin(), contact.cells.end(),
                       [](const CellContacts& c) { return c.moved <= skin; });
}

Vec2 node_in_frame(const Suspension& cells, const ContactPair& pair) {
    return cells.position(pair.node) - pair.shift;
}

/// Searches the whole other outline for the point nearest to the node of `pair` and sets the pair's
/// window.
NearestPoint search_again(const ContactModel& model, const Suspension& cells,
                          const ContactState& contact, CellContacts& mine, Vec2 drift,
                          ContactPair& pair) {
    const CellContacts& other = contact.cells[pair.other];
    const SearchResult found =
        search_nearest(outline(cells, pair.other), other.boxes, drift, other.moved,
                       node_in_frame(cells, pair), model.nearest, horizon, mine.lower);
    pair.window_first = found.window_first;
    pair.outside = found.outside - mine.moved - other.moved;
    return found.nearest;
}

/// Lists the pairs of one cell.
void list_pairs(const ContactModel& model, const Suspension& cells, ContactState& contact,
                int cell) {
    CellContacts& mine = contact.cells[cell];
    const double reach = contact.listed_reach + 2.0 * skin;
    // Room for every node to have two neighbours, so that lists seldom grow during a run.
    mine.pairs.reserve(2 * cells.node_count(cell));
    mine.hits.reserve(2 * cells.node_count(cell));
    mine.neighbours.reserve(32);
    mine.pairs.clear();
    contact.bins.near(cell, mine.neighbours);
    for (const Neighbour& neighbour : mine.neighbours) {
        const Bounds& box = contact.bins.bounds(neighbour.cell);
        for (int k = cells.first[cell]; k < cells.first[cell + 1]; ++k) {
            const Vec2 p = cells.position(k) - neighbour.shift;
            if (p.x < box.low.x - reach || p.x > box.high.x + reach || p.y < box.low.y - reach ||
                p.y > box.high.y + reach)
                continue;
            ContactPair pair{k, neighbour.cell, 0, 0.0, neighbour.shift};
            const NearestPoint found = search_again(model, cells, contact, mine, {}, pair);
            if (found.distance2 <= reach * reach) mine.pairs.push_back(pair);
        }
    }
    mine.hits.reserve(mine.pairs.capacity());
}

/// Lists all pairs anew. Allocates where there are more pairs than ever before.
void list_all_pairs(const ContactModel& model, const Lattice& lattice, const Suspension& cells,
                    ContactState& contact) {
    const int count = cells.cell_count();
    on_one_thread([&] {
        contact.cells.resize(count);
        contact.bounds.resize(count);
        contact.listed_reach = model.reach();
        contact.listed_x = cells.x;
        contact.listed_y = cells.y;
    });
    int most_nodes = 0;
    for (int c = 0; c < count; ++c) most_nodes = std::max(most_nodes, cells.node_count(c));
    const auto [begin, end] = team_share(count);
    for (int c = begin; c < end; ++c) {
        contact.cells[c].moved = 0.0;
        contact.cells[c].lower.resize(most_nodes / window + 1);
        contact.bounds[c] = bounds_of(outline(cells, c), lattice);
        set_boxes(outline(cells, c), contact.cells[c].boxes);
    }
    team_barrier();
    on_one_thread(
        [&] { contact.bins.sort(lattice, contact.bounds, contact.listed_reach + 2.0 * skin); });
    for (int c = begin; c < end; ++c) list_pairs(model, cells, contact, c);
    team_barrier();
}

/// Outward direction of the outline at a node, not normalised: the mean of the normals of its
/// segments.
Vec2 outward_at_node(const Outline& outline, int node) {
    const int size = outline.size();
    const Vec2 here = outline[node];
    const Vec2 before = here - outline[node > 0 ? node - 1 : size - 1];
    const Vec2 after = outline[node + 1 < size ? node + 1 : 0] - here;
    return turned_right(before * norm(after) + after * norm(before));
}

/// The hit of a pair whose nearest point is given: gap with its sign, and direction. A point at a
/// node is always told as the start of the segment after it, so that equal points give equal bits.
ContactHit hit_of(const Suspension& cells, const ContactPair& pair, NearestPoint at) {
    const Outline other = outline(cells, pair.other);
    const int size = other.size();
    if (at.along == 1.0) at = {at.distance2, at.segment + 1 < size ? at.segment + 1 : 0, 0.0};
    const int next = at.segment + 1 < size ? at.segment + 1 : 0;
    const Vec2 edge = other[next] - other[at.segment];
    const Vec2 apart = node_in_frame(cells, pair) - other[at.segment] - at.along * edge;
    const Vec2 outward = at.along > 0.0 ? turned_right(edge) : outward_at_node(other, at.segment);
    const double distance = norm(apart);
    const double side = dot(apart, outward) < 0.0 ? -1.0 : 1.0;
    ContactHit hit;
    hit.node = pair.node;
    hit.other = pair.other;
    hit.from = cells.first[pair.other] + at.segment;
    hit.to = cells.first[pair.other] + next;
    hit.along = at.along;
    hit.gap = side * distance;
    // On the membrane itself the line between the two points has no direction; its normal has.
    hit.normal = distance > 0.0 ? (side / distance) * apart : outward / norm(outward);
    return hit;
}

/// Half the arc length that belongs to a node: each of the two membranes contributes half of the
/// pressure.
double share_of(const Suspension& cells, int cell, int node) {
    const int first = cells.first[cell], last = cells.first[cell + 1] - 1;
    const Vec2 here = cells.position(node);
    const Vec2 before = cells.position(node > first ? node - 1 : last);
    const Vec2 after = cells.position(node < last ? node + 1 : first);
    return 0.25 * (norm(here - before) + norm(after - here));
}

/// Finds the pairs of one cell that are within reach now.
void find_hits(const ContactModel& model, const Suspension& cells, ContactState& contact, int cell,
               Vec2 drift) {
    CellContacts& mine = contact.cells[cell];
    const double reach2 = contact.listed_reach * contact.listed_reach;
    mine.hits.clear();
    for (ContactPair& pair : mine.pairs) {
        NearestPoint at = nearest_in_window(outline(cells, pair.other), node_in_frame(cells, pair),
                                            pair.window_first, model.nearest);
        const double bound = pair.outside - mine.moved - contact.cells[pair.other].moved - rounding;
        if (!(bound > 0.0 && at.distance2 < bound * bound)) {
            at = search_again(model, cells, contact, mine, drift, pair);
        }
        if (!(at.distance2 <= reach2)) continue;
        mine.hits.push_back(hit_of(cells, pair, at));
        mine.hits.back().share = share_of(cells, cell, pair.node);
    }
}

/// Sets the forces of one cell's hits.
TT_CLONES void press(const Morse& law, double range, double alpha, std::vector<ContactHit>& hits) {
    for (ContactHit& hit : hits) {
        const double p = hit.gap <= range ? law.pressure(hit.gap, alpha) : 0.0;
        hit.force = p * hit.share * hit.normal;
    }
}

void set_forces(const ContactModel& model, double alpha, CellContacts& mine) {
    mine.smallest_gap = HUGE_VAL;
    mine.repelled = 0;
    for (ContactHit& hit : mine.hits) {
        hit.force = {};
        mine.smallest_gap = std::min(mine.smallest_gap, hit.gap);
    }
    if (const auto* law = std::get_if<Morse>(&model.law))
        press(*law, model.range, law->scale_repulsion ? alpha : 1.0, mine.hits);
    if (model.repulsion_range <= 0.0) return;
    const ShortRangeRepulsion repulsion{model.repulsion_range, model.repulsion_strength};
    for (ContactHit& hit : mine.hits) {
        if (hit.gap >= repulsion.range) continue;
        hit.force += repulsion.pressure(hit.gap) * hit.share * hit.normal;
        ++mine.repelled;
    }
}

/// Adds all forces that fall on the cells [begin, end), in the order of the lists.
void add_hits(Suspension& cells, const ContactState& contact, int begin, int end) {
    const auto add = [&](int node, Vec2 force) {
        cells.fx[node] += force.x;
        cells.fy[node] += force.y;
    };
    for (int c = 0; c < cells.cell_count(); ++c) {
        const bool own = begin <= c && c < end;
        for (const ContactHit& hit : contact.cells[c].hits) {
            if (own) add(hit.node, hit.force);
            if (hit.other < begin || hit.other >= end) continue;
            const Vec2 to = hit.along * hit.force;
            add(hit.from, to - hit.force);
            add(hit.to, -to);
        }
    }
}

/// Short-range repulsion of the walls at y = 0 and y = ny from the nodes of one cell; returns how
/// many felt it.
std::int64_t repel_from_walls(const ContactModel& model, const Lattice& lattice, Suspension& cells,
                              int cell) {
    const ShortRangeRepulsion repulsion{model.repulsion_range, model.repulsion_strength};
    std::int64_t count = 0;
    for (int k = cells.first[cell]; k < cells.first[cell + 1]; ++k) {
        const double below = cells.y[k];
        const double above = lattice.ny - cells.y[k];
        if (below >= repulsion.range && above >= repulsion.range) continue;
        const double pressure = repulsion.pressure(below) - repulsion.pressure(above);
        cells.fy[k] += pressure * 2.0 * share_of(cells, cell, k);
        ++count;
    }
    return count;
}

}  // namespace

void add_pair_forces(const ContactModel& model, const Lattice& lattice, Suspension& cells,
                     ContactState& contact) {
    if (!(model.reach() > 0.0)) return;
    Vec2 drift;
    if (!lists_hold(model, cells, contact, drift)) {
        list_all_pairs(model, lattice, cells, contact);
        drift = {};
    }
    const auto [begin, end] = team_share(cells.cell_count());
    for (int c = begin; c < end; ++c) {
        find_hits(model, cells, contact, c, drift);
        set_forces(model, cells.alpha[c], contact.cells[c]);
    }
    team_barrier();
    add_hits(cells, contact, begin, end);
    if (lattice.walls && model.repulsion_range > 0.0) {
        for (int c = begin; c < end; ++c)
            contact.cells[c].repelled += repel_from_walls(model, lattice, cells, c);
    }
    team_barrier();
    on_one_thread([&] {
        contact.smallest_gap = contact.listed_reach;
        for (const CellContacts& c : contact.cells) {
            contact.repulsion_count += c.repelled;
            contact.smallest_gap = std::min(contact.smallest_gap, c.smallest_gap);
        }
    });
}

}  // namespace tt
