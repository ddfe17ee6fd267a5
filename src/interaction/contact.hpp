#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "grid/lattice.hpp"
#include "membrane/suspension.hpp"

namespace tt {

struct NoContact {};

/// Morse attraction and repulsion (Eqs. 16, 17 as corrected), a pressure between two membranes at distance r:
/// f(r) = 2 β D_e [e^{2β(r₀−r)} − e^{β(r₀−r)}], positive = repulsive for r < r₀, times α(λ_C) where repulsive and hardening asks.
struct Morse {
    double energy = 0.0;              ///< D_e
    double decay = 1.0;               ///< β
    double zero_force_distance = 1.0; ///< r₀
    bool scale_repulsion = false;     ///< hardening applies to contact (Table 1)
};
using ContactLaw = std::variant<NoContact, Morse>;

enum class Nearest : std::uint8_t { node, segment };

/// Everything between two cells, or between a cell and a wall. Lattice units.
struct ContactModel {
    ContactLaw law;
    Nearest nearest = Nearest::segment;
    double range = 0.0;                ///< query range R
    double repulsion_range = 0.0;      ///< short-range repulsion below this gap; 0: off
    double repulsion_strength = 0.0;   ///< its pressure at zero gap
};

/// Counters since the start (checkpointed) and the neighbour search's work arrays (derived).
struct ContactState {
    std::int64_t repulsion_count = 0;   ///< node–steps on which the short-range repulsion acted
    double smallest_gap = 0.0;          ///< between cells, at the last step [sites]
    std::vector<std::int32_t> work;
};

/// Adds the pair forces to fx, fy: for each node the nearest point (node or segment) of every other cell within range;
/// node force f Δs along the line between them, the opposite on the partner. Neighbour search by bins, linear in the
/// number of nodes; periodic in x. Fixed order of sums, any number of threads. Team function.
void add_pair_forces(const ContactModel& model, const Lattice& lattice, Suspension& cells, ContactState& contact);

/// A node of one cell found inside another.
struct Overlap {
    int node = 0;
    int cell = 0;        ///< whose node
    int other = 0;       ///< inside which
    double depth = 0.0;  ///< distance to the other outline [sites]
};
std::vector<Overlap> find_overlaps(const Lattice& lattice, const Suspension& cells);

}  // namespace tt
