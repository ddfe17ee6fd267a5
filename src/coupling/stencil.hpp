#pragma once

#include <cstdint>
#include <vector>

#include "coupling/delta/delta.hpp"
#include "grid/field.hpp"
#include "membrane/suspension.hpp"

namespace tt {

/// Where each node meets the lattice: the block of points × points sites from (i, j) and the
/// weights along x and along y, whose products sum to 1. Computed once a step and shared by spread
/// and interpolate, which are therefore adjoint to the bit; weighed in double and kept in the
/// precision of the fields. i is wrapped into the box, so that the block lies on sites or on the
/// halo; so is j where y is periodic.
template <class Real = double>
struct Stencils {
    static constexpr int width = 4;  ///< weights kept for each axis, those past the block 0
    int points = width;              ///< sites of a block along each axis
    std::vector<std::int32_t> i, j;  ///< per node: lower left site of the block
    std::vector<Real> wx, wy;        ///< per node: `width` weights along each axis
    std::vector<Real> sx, sy;        ///< per node: their derivatives by the node's position

    Stencils() = default;
    explicit Stencils(int node_count)
        : i(node_count),
          j(node_count),
          wx(width * node_count),
          wy(width * node_count),
          sx(width * node_count),
          sy(width * node_count) {}
};

/// Weights of every node. Near a wall, where the block sticks out of the fluid, the y weights are
/// made one-sided so that force, torque and linear velocity profiles are still exact
/// (docs/theory/coupling.md). Team function, by cells.
template <class Real>
void locate(const Delta& delta, const Lattice& lattice, const Suspension& cells,
            Stencils<Real>& stencils);

/// What a node hands to the sites and takes from them: force and velocity (Eqs. 9, 7), or also the
/// first moment of each, which the jump correction (coupling/jump.hpp) needs where the viscosities
/// differ.
enum class Order : std::uint8_t { zeroth, first };

/// Eqs. 8, 9: adds the node forces (and dipoles) to the force field, halo included (then
/// Exchange::fold). Owner of rows: every thread adds, in node
/// order, what falls on its own rows, so the bits do not depend on the number of threads. Team
/// function, by rows; waits for stencils and forces.
template <class Real>
void spread(Order order, const Stencils<Real>& stencils, const Suspension& cells,
            VectorField<Real>& force);

/// Zeroes the field, halo included, whatever the step before left there. Team function, by rows.
template <class Real>
void clear(VectorField<Real>& force);

/// Eq. 7: velocities (and shear rates) of one cell's nodes from the velocity field (halo filled).
template <class Real>
void interpolate(Order order, const Stencils<Real>& stencils, const VectorField<Real>& velocity,
                 Suspension& cells, int cell);

}  // namespace tt
