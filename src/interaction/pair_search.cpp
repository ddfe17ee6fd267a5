#include "interaction/pair_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"
#include "base/parallel.hpp"

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
    const auto [begin, end] = own_cells(cells);
    for (int c = begin; c < end; ++c) {
        const int k = cells.first[c];
        contact.cells[c].moved =
            std::sqrt(largest_move2(&cells.x[k], &cells.y[k], &contact.listed_x[k],
                                    &contact.listed_y[k], cells.node_count(c), drift));
    }
    team_barrier();  // all know how far their cells have moved
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
    const auto [begin, end] = own_cells(cells);
    for (int c = begin; c < end; ++c) {
        contact.cells[c].moved = 0.0;
        contact.cells[c].lower.resize(most_nodes / segments_at_once + 1);
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

}  // namespace

Vec2 update_pairs(const ContactModel& model, const Lattice& lattice, const Suspension& cells,
                  ContactState& contact) {
    Vec2 drift;
    if (lists_hold(model, cells, contact, drift)) return drift;
    list_all_pairs(model, lattice, cells, contact);
    return {};
}

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

}  // namespace tt
