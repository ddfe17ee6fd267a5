#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "fluid/walls.hpp"
#include "grid/lattice.hpp"
#include "interaction/morse.hpp"
#include "interaction/nearest.hpp"
#include "interaction/neighbours.hpp"
#include "membrane/suspension.hpp"

namespace tt {

struct NoContact {
    static constexpr std::string_view name = "none";
    friend bool operator==(const NoContact&, const NoContact&) = default;
};
using ContactLaw = std::variant<NoContact, Morse>;

/// Everything between two cells, or between a cell and a wall. Lattice units.
struct ContactModel {
    ContactLaw law;            ///< between any two cells …
    std::vector<Morse> pairs;  ///< … but [kinds · own + other] where it depends on their kinds
    Nearest nearest = Nearest::segment;
    double range = 0.0;                  ///< query range R
    double repulsion_range = 0.0;        ///< short-range repulsion below this gap; 0: off
    double repulsion_strength = 0.0;     ///< its pressure at zero gap
    int kinds = 1;                       ///< of cells
    int interval = 1;                    ///< steps from one measurement of the gaps to the next
    std::shared_ptr<const Walls> walls;  ///< of any shape; none: those of the lattice

    /// All laws that act between two membranes.
    std::vector<Morse> laws() const {
        const auto* one = std::get_if<Morse>(&law);
        return !one ? std::vector<Morse>{} : pairs.empty() ? std::vector<Morse>{*one} : pairs;
    }
    /// How far apart two membranes can feel each other; 0: nothing to do.
    double reach() const {
        const double law_range = std::holds_alternative<NoContact>(law) ? 0.0 : range;
        return law_range > repulsion_range ? law_range : repulsion_range;
    }
};

/// A node and a neighbouring cell that were near when pairs were last listed.
struct ContactPair {
    std::int32_t node = 0;          ///< of the suspension
    std::int32_t other = 0;         ///< cell
    std::int32_t window_first = 0;  ///< segments among which the nearest is, as long as
    double outside =
        0.0;     ///< … it is nearer than this bound for all others, less what has moved since
    Vec2 shift;  ///< of the image of the other cell, whole periods
};

/// The pairs within reach at this step and their forces: one array a quantity, since their
/// arithmetic is done side by side.
struct ContactHits {
    int count = 0;
    std::vector<std::int32_t> node, other;
    std::vector<std::int32_t> from, to;  ///< nodes of the partner's segment
    std::vector<std::int32_t> before;    ///< the node before `from`
    std::vector<double> along;           ///< place on it
    std::vector<double> x, y;            ///< the node, its image beside the partner
    std::vector<double> gap;             ///< negative where the node is inside the partner
    std::vector<double> area_x, area_y;  ///< half the node's arc length, directed away from the
                                         ///< partner: times the pressure it is the force
    std::vector<double> pressure;

    /// Room for so many; keeps none.
    void make_room(std::size_t most) {
        count = 0;
        for (auto* array : {&node, &other, &from, &to, &before}) array->resize(most);
        for (auto* array : {&along, &x, &y, &gap, &area_x, &area_y, &pressure}) array->resize(most);
    }
};

/// What one cell keeps for its search.
struct CellContacts {
    std::vector<ContactPair> pairs;
    ContactHits hits;
    std::vector<Neighbour> neighbours;
    std::vector<double> lower;
    SegmentBoxes boxes;
    double moved = 0.0;  ///< largest displacement of a node since pairs were listed, less the drift
    double smallest_gap = 0.0;
    std::int64_t repelled = 0;
};

/// Counters since the start (checkpointed) and the neighbour search's work arrays: derived, and
/// without influence on the forces, since a search through the lists finds what a search through
/// everything would find.
struct ContactState {
    std::int64_t repulsion_count =
        0;  ///< how often the short-range repulsion acted: nodes, partners and measurements
    double smallest_gap = 0.0;  ///< between cells, as last measured [sites]; the reach where none
                                ///< is nearer

    std::vector<CellContacts> cells;
    std::vector<double> listed_x, listed_y;  ///< node positions when pairs were last listed
    std::vector<Bounds> bounds;
    CellBins bins;
    double listed_reach = -1.0;
};

/// Adds the forces between cells to fx, fy. They are measured at the steps that are multiples of
/// `interval` and held in between, each on its node: their sum stays zero. Every node within reach
/// of another cell's outline feels the pressure f of its gap r to the nearest point there, along
/// the line between the two; the partner's two nodes share the opposite by the lever rule, so force
/// and torque balance. Each pair of membranes is integrated from both sides, nodes of A to segments
/// of B and nodes of B to segments of A, each with half of f Δs: the mean of two quadratures, the
/// same whichever cell comes first. α is that of the node's cell. Also the short-range repulsion,
/// between cells and from walls.
///
/// A cell's periodic images are other cells, its own included. Sums in a fixed order: same bits for
/// any team and after any restart. Team function, by cells; waits for hits of all.
void add_pair_forces(const ContactModel& model, const Lattice& lattice, std::int64_t step,
                     Suspension& cells, ContactState& contact);

/// A node of one cell found inside another.
struct Overlap {
    int node = 0;
    int cell = 0;        ///< whose node
    int other = 0;       ///< inside which
    double depth = 0.0;  ///< distance to the other outline [sites]
};

/// Every node that lies inside another cell, by cell, other and node. Cells by bins, then boxes,
/// then nodes.
std::vector<Overlap> find_overlaps(const Lattice& lattice, const Suspension& cells);

/// Least distance of a node to the outline of another cell or to an image of its own [sites]; the
/// reach where none is nearer. Negative where cells overlap.
double smallest_gap(const Lattice& lattice, Suspension cells, double reach);

}  // namespace tt
