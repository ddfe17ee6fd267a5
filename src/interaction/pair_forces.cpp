#include <algorithm>
#include <cmath>
#include <optional>

#include "base/isa.hpp"
#include "base/parallel.hpp"
#include "interaction/contact.hpp"
#include "interaction/pair_search.hpp"

namespace tt {
namespace {

/// Half the arc length that belongs to a node of the cell [first, last]: each of the two membranes
/// contributes half of the pressure.
TT_INLINE double share_of(const double* x, const double* y, int first, int last, int node) {
    const Vec2 here{x[node], y[node]};
    const int before = node > first ? node - 1 : last, after = node < last ? node + 1 : first;
    return 0.25 * (norm(here - Vec2{x[before], y[before]}) + norm(Vec2{x[after], y[after]} - here));
}

/// Gap, with its sign, and directed area of the hits of one cell, whose nodes are [first, last].
TT_CLONES void measure_hits(const double* x, const double* y, int first, int last,
                            ContactHits& hits) {
    const auto at = [x, y](int node) TT_INLINE_LAMBDA { return Vec2{x[node], y[node]}; };
    const int count = hits.count;
#pragma omp simd
    for (int k = 0; k < count; ++k) {
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
        const double share = share_of(x, y, first, last, hits.node[k]) / norm(away);
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

/// The same where the law depends on the kind of the partner: `laws` are those of this cell's kind.
TT_CLONES void press_by_kind(const Morse* laws, const std::int32_t* kind, double range,
                             double alpha, ContactHits& hits) {
    const int count = hits.count;
#pragma omp simd
    for (int k = 0; k < count; ++k) {
        const Morse& law = laws[kind[hits.other[k]]];
        const double pressure = law.pressure(hits.gap[k], law.scale_repulsion ? alpha : 1.0);
        hits.pressure[k] = hits.gap[k] <= range ? pressure : 0.0;
    }
}

void set_pressures(const ContactModel& model, const Suspension& cells, int cell,
                   CellContacts& mine) {
    const double alpha = cells.alpha[cell];
    ContactHits& hits = mine.hits;
    mine.smallest_gap = HUGE_VAL;
    mine.repelled = 0;
    for (int k = 0; k < hits.count; ++k)
        mine.smallest_gap = std::min(mine.smallest_gap, hits.gap[k]);
    if (!model.pairs.empty())
        press_by_kind(&model.pairs[model.kinds * cells.kind[cell]], cells.kind.data(), model.range,
                      alpha, hits);
    else if (const auto* law = std::get_if<Morse>(&model.law))
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

/// [begin, end) of cells in a row that have this thread's share of the pairs: some cells have ten
/// times as many as others.
std::pair<int, int> share_of_pairs(const ContactState& contact) {
    const int size = team_size(), rank = team_rank();
    const auto weight = [](const CellContacts& c) { return c.pairs.size() + 1; };
    std::size_t total = 0, before = 0;
    for (const CellContacts& c : contact.cells) total += weight(c);
    int begin = 0, end = 0;
    for (const CellContacts& c : contact.cells) {
        // Whose share holds the middle of this cell's pairs?
        const auto owner = static_cast<int>((2 * before + weight(c)) * size / (2 * total));
        begin += owner < rank ? 1 : 0;
        end += owner <= rank ? 1 : 0;
        before += weight(c);
    }
    return {begin, end};
}

/// Adds to the pair forces all that fall on the cells [begin, end), in the order of the lists.
void add_hits(Suspension& cells, const ContactState& contact, int begin, int end) {
    const auto add = [&](int node, Vec2 force) {
        cells.pair_fx[node] += force.x;
        cells.pair_fy[node] += force.y;
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

/// Pushes the nodes of one cell by the pressure that `pressure_at(node)` gives, directed, if any;
/// returns how many it pushed.
template <class Pressure>
std::int64_t push_nodes(Suspension& cells, int cell, Pressure&& pressure_at) {
    const int first = cells.first[cell], last = cells.first[cell + 1] - 1;
    std::int64_t count = 0;
    for (int k = first; k <= last; ++k) {
        const std::optional<Vec2> pressure = pressure_at(k);
        if (!pressure) continue;
        const double length = 2.0 * share_of(cells.x.data(), cells.y.data(), first, last, k);
        cells.pair_fx[k] += pressure->x * length;
        cells.pair_fy[k] += pressure->y * length;
        ++count;
    }
    return count;
}

/// Short-range repulsion of the walls from the nodes of one cell: of those at y = 0 and y = ny, or
/// of walls of any shape, away from their nearest point. Returns how many felt it.
std::int64_t repel_from_walls(const ContactModel& model, const Lattice& lattice, Suspension& cells,
                              int cell) {
    const ShortRangeRepulsion repulsion{model.repulsion_range, model.repulsion_strength};
    if (const Walls* walls = model.walls.get())
        return push_nodes(cells, cell, [&](int k) -> std::optional<Vec2> {
            const Vec2 here = cells.position(k);
            const double gap = walls->distance_at(here);
            if (gap >= repulsion.range) return std::nullopt;
            return repulsion.pressure(gap) * walls->away_at(here);
        });
    if (!lattice.walls) return 0;
    return push_nodes(cells, cell, [&](int k) -> std::optional<Vec2> {
        const double below = cells.y[k], above = lattice.ny - cells.y[k];
        if (below >= repulsion.range && above >= repulsion.range) return std::nullopt;
        return Vec2{0.0, repulsion.pressure(below) - repulsion.pressure(above)};
    });
}

/// The smallest gap of all cells, and how often the repulsion acted.
void count_up(ContactState& contact) {
    contact.smallest_gap = contact.listed_reach;
    for (const CellContacts& c : contact.cells) {
        contact.repulsion_count += c.repelled;
        contact.smallest_gap = std::min(contact.smallest_gap, c.smallest_gap);
    }
}

/// Sets the pair forces of all cells.
void measure_pair_forces(const ContactModel& model, const Lattice& lattice, Suspension& cells,
                         ContactState& contact) {
    const Vec2 drift = update_pairs(model, lattice, cells, contact);
    // These cells may be another thread's: it has set their α, update_pairs waited.
    const auto [first, past] = share_of_pairs(contact);
    for (int c = first; c < past; ++c) {
        CellContacts& mine = contact.cells[c];
        const int node = cells.first[c], count = cells.node_count(c);
        std::fill_n(&cells.pair_fx[node], count, 0.0);
        std::fill_n(&cells.pair_fy[node], count, 0.0);
        find_hits(model, cells, contact, c, drift);
        measure_hits(cells.x.data(), cells.y.data(), node, node + count - 1, mine.hits);
        set_pressures(model, cells, c, mine);
        if (model.repulsion_range > 0.0)
            mine.repelled += repel_from_walls(model, lattice, cells, c);
    }
    team_barrier();  // all have their hits
    const auto [begin, end] = own_cells(cells);
    add_hits(cells, contact, begin, end);
    if (team_rank() == 0) count_up(contact);
}

TT_CLONES void add(const double* values, int count, double* sums) {
#pragma omp simd
    for (int n = 0; n < count; ++n) sums[n] += values[n];
}

}  // namespace

void add_pair_forces(const ContactModel& model, const Lattice& lattice, std::int64_t step,
                     Suspension& cells, ContactState& contact) {
    if (!(model.reach() > 0.0)) return;
    if (step % model.interval == 0) measure_pair_forces(model, lattice, cells, contact);
    const auto [begin, end] = own_nodes(cells);
    add(cells.pair_fx.data() + begin, end - begin, cells.fx.data() + begin);
    add(cells.pair_fy.data() + begin, end - begin, cells.fy.data() + begin);
}

}  // namespace tt
