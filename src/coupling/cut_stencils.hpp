#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "coupling/stencil.hpp"
#include "fluid/walls.hpp"

namespace tt {

/// A node whose block a wall of any shape cuts: weights of all its sites, row after row, those of
/// closed ones 0.
template <class Real>
struct CutStencil {
    std::int32_t node, i, j;
    std::array<Real, 16> weight, slope_x, slope_y;
    double whole = 1.0;  ///< share of the jump correction that is right: 1 of an uncut kernel
    Vec2 sampled;        ///< velocity, uncorrected
};

/// The nodes beside walls of any shape, by cell.
template <class Real = double>
struct CutStencils {
    int points = Stencils<>::width;  ///< sites of a block along each axis
    std::vector<std::vector<CutStencil<Real>>> of_cell;
};

/// Makes the weights of the nodes beside walls one-sided: w_k = φ_k (a + b·r_k) over the open
/// sites, r = site − node, with a and b such that Σ w = 1 and Σ w r = 0. Force and torque are
/// conserved up to the wall and a linear velocity is interpolated exactly, as beside the lattice's
/// own walls; slopes are w M⁻¹ r, M = Σ w r rᵀ. Where the open sites do not span the plane the
/// weights are φ over its sum; a node without any open site gives and takes nothing. In `stencils`,
/// which hold the kernel's weights, such nodes weigh nothing from then on. Team function, by cells.
template <class Real>
void cut_at_walls(const Walls& walls, const Suspension& cells, Stencils<Real>& stencils,
                  CutStencils<Real>& cut);

/// `spread` and `interpolate` (coupling/stencil.hpp) of these nodes, after those of all others.
template <class Real>
void spread_cut(Order order, const CutStencils<Real>& cut, const Suspension& cells,
                VectorField<Real>& force);
template <class Real>
void interpolate_cut(Order order, CutStencils<Real>& cut, const VectorField<Real>& velocity,
                     Suspension& cells, int cell);

/// The constants of the jump correction (coupling/jump.hpp) are those of a whole kernel. A cut one
/// answers its own load less, and the whole correction would push nodes the wrong way round: they
/// blow up. So dipoles and corrections of velocity are taken times 2 s − 1, s the share of the
/// kernel's weight that is left, and not at all below one half. The first after `set_dipoles`, a
/// team function by cells; the second after `correct_velocities`.
template <class Real>
void weaken_dipoles(const CutStencils<Real>& cut, Suspension& cells);
template <class Real>
void weaken_corrections(const CutStencils<Real>& cut, Suspension& cells, int cell);

}  // namespace tt
