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
    mine.hits.make_room(mine.pairs.capacity());
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

/// Keeps a pair as a hit. A point at a node is always told as the start of the segment after it, so
/// that equal points give equal bits.
void keep(const Suspension& cells, const ContactPair& pair, Vec2 node, NearestPoint at,
          ContactHits& hits) {
    const int first = cells.first[pair.other], size = cells.node_count(pair.other);
    const auto next = [size](int segment) { return segment + 1 < size ? segment + 1 : 0; };
    const bool at_end = at.along == 1.0;
    const int from = at_end ? next(at.segment) : at.segment;
    const int k = hits.count++;
    hits.node[k] = pair.node;
    hits.other[k] = pair.other;
    hits.from[k] = first + from;
    hits.to[k] = first + next(from);
    hits.before[k] = first + (from > 0 ? from : size) - 1;
    hits.along[k] = at_end ? 0.0 : at.along;
    hits.x[k] = node.x;
    hits.y[k] = node.y;
}

/// Finds the pairs of one cell that are within reach now.
void find_hits(const ContactModel& model, const Suspension& cells, ContactState& contact, int cell,
               Vec2 drift) {
    CellContacts& mine = contact.cells[cell];
    const double reach2 = contact.listed_reach * contact.listed_reach;
    const int count = static_cast<int>(mine.pairs.size());
    mine.hits.count = 0;
    WindowBatch batch;
    for (int begin = 0; begin < count; begin += WindowBatch::size) {
        const int size = std::min(count - begin, WindowBatch::size);
        for (int k = 0; k < size; ++k) {
            const ContactPair& pair = mine.pairs[begin + k];
            const Vec2 node = node_in_frame(cells, pair);
            batch.x[k] = node.x;
            batch.y[k] = node.y;
            batch.begin[k] = cells.first[pair.other];
            batch.end[k] = cells.first[pair.other + 1];
            batch.first[k] = batch.begin[k] + pair.window_first;
        }
        nearest_in_windows(cells.x.data(), cells.y.data(), model.nearest, size, batch);
        for (int k = 0; k < size; ++k) {
            ContactPair& pair = mine.pairs[begin + k];
            NearestPoint at{batch.distance2[k], batch.segment[k] - batch.begin[k], batch.along[k]};
            const double bound =
                pair.outside - mine.moved - contact.cells[pair.other].moved - rounding;
            if (!(bound > 0.0 && at.distance2 < bound * bound))
                at = search_again(model, cells, contact, mine, drift, pair);
            if (at.distance2 <= reach2) keep(cells, pair, {batch.x[k], batch.y[k]}, at, mine.hits);
        }
    }
}

/// Gap, with its sign, and directed area of the hits of one cell, whose nodes are [first, last].
TT_CLONES void measure_hits(const double* x, const double* y, int first, int last,
                            ContactHits& hits) {
    const auto at = [x, y](int node) TT_INLINE_LAMBDA { return Vec2{x[node], y[node]}; };
    const int count = hits.count;
#pragma omp simd
    for (int k = 0; k < count; ++k) {
        const int node = hits.node[k];
        const Vec2 here = at(node);
        const double arc = norm(here - at(node > first ? node - 1 : last)) +
                           norm(at(node < last ? node + 1 : first) - here);

        const Vec2 from = at(hits.from[k]);
        const Vec2 edge = at(hits.to[k]) - from;
        const Vec2 back = from - at(hits.before[k]);
        const Vec2 apart = Vec2{hits.x[k], hits.y[k]} - from - hits.along[k] * edge;
        const double distance = norm(apart);
        // At a node the outline's direction is the mean of its two segments'.
        const Vec2 mean = back * norm(edge) + edge * norm(back);
        const bool at_node = !(hits.along[k] > 0.0);
        const Vec2 outward = turned_right({at_node ? mean.x : edge.x, at_node ? mean.y : edge.y});
        const double side = dot(apart, outward) < 0.0 ? -1.0 : 1.0;
        // On the membrane itself the line between the two points has no direction; its normal has.
        const bool on = !(distance > 0.0);
        const Vec2 away{on ? outward.x : side * apart.x, on ? outward.y : side * apart.y};
        const double share = 0.25 * arc / norm(away);
        hits.gap[k] = side * distance;
        hits.area_x[k] = share * away.x;
        hits.area_y[k] = share * away.y;
    }
}

/// Sets the pressures of one cell's hits.
TT_CLONES void press(const Morse& law, double range, double alpha, ContactHits& hits) {
    const int count = hits.count;
#pragma omp simd
    for (int k = 0; k < count; ++k) {
        const double pressure = law.pressure(hits.gap[k], alpha);
        hits.pressure[k] = hits.gap[k] <= range ? pressure : 0.0;
    }
}

void set_pressures(const ContactModel& model, double alpha, CellContacts& mine) {
    ContactHits& hits = mine.hits;
    mine.smallest_gap = HUGE_VAL;
    mine.repelled = 0;
    for (int k = 0; k < hits.count; ++k)
        mine.smallest_gap = std::min(mine.smallest_gap, hits.gap[k]);
    if (const auto* law = std::get_if<Morse>(&model.law))
        press(*law, model.range, law->scale_repulsion ? alpha : 1.0, hits);
    else
        std::fill_n(hits.pressure.begin(), hits.count, 0.0);
    if (model.repulsion_range <= 0.0) return;
    const ShortRangeRepulsion repulsion{model.repulsion_range, model.repulsion_strength};
    for (int k = 0; k < hits.count; ++k) {
        if (hits.gap[k] >= repulsion.range) continue;
        hits.pressure[k] += repulsion.pressure(hits.gap[k]);
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
        const ContactHits& hits = contact.cells[c].hits;
        for (int k = 0; k < hits.count; ++k) {
            const Vec2 force = hits.pressure[k] * Vec2{hits.area_x[k], hits.area_y[k]};
            if (own) add(hits.node[k], force);
            if (hits.other[k] < begin || hits.other[k] >= end) continue;
            const Vec2 to = hits.along[k] * force;
            add(hits.from[k], to - force);
            add(hits.to[k], -to);
        }
    }
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
        measure_hits(cells.x.data(), cells.y.data(), cells.first[c], cells.first[c + 1] - 1,
                     contact.cells[c].hits);
        set_pressures(model, cells.alpha[c], contact.cells[c]);
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
