#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vec2.hpp"

namespace tt {

/// All cells' membrane nodes, cell after cell, each outline counter-clockwise. Structure of arrays,
/// lattice units, per unit depth. Positions are unwrapped: a cell that left through an end keeps
/// counting x on. Segment k joins node k to its successor on the same cell.
struct Suspension {
    std::vector<std::int32_t> first{0};  ///< nodes of cell c are first[c] … first[c+1]

    // Per node.
    std::vector<double> x, y;              ///< position
    std::vector<double> fx, fy;            ///< force on the fluid
    std::vector<double> pair_fx, pair_fy;  ///< of it, by other cells and walls, as last measured
    std::vector<double> ux, uy;            ///< velocity of the last step
    std::vector<double> ux_sampled, uy_sampled;  ///< the fluid's, sampled in the last step
    std::vector<double> rest_curvature;          ///< κ₀
    std::vector<double> dipole_xx,
        dipole_xy;  ///< symmetric, traceless force dipole on the fluid (coupling/jump.hpp)
    std::vector<double> viscous_moment;      ///< membrane/viscosity.hpp
    std::vector<double> rigid_fx, rigid_fy;  ///< λ ds of a rigid body (membrane/rigid.hpp)
    std::vector<double> rate_xx, rate_xy;  ///< ∂ₓuₓ − ∂ᵧuᵧ and ∂ᵧuₓ + ∂ₓuᵧ of the last step

    // Per segment, indexed by its first node.
    std::vector<double> rest_length;  ///< l₀
    std::vector<double> stiffness;    ///< d(T α)/dλ/l₀ of the last step, at least 0; derived
    std::vector<double> viscous_tension;  ///< membrane/viscosity.hpp

    // Per cell.
    std::vector<std::int32_t> id;             ///< its number for ever, whoever leaves
    std::vector<std::int32_t> kind;           ///< of which of the model's kinds it is
    std::vector<std::uint8_t> led;            ///< 1: moved by the feed that it comes from
    std::vector<double> reference_area;       ///< A_ref
    std::vector<double> reference_perimeter;  ///< L₀, the sum of rest lengths
    std::vector<double> alpha;  ///< α(λ_C) of the last step: scales area pressure and repulsion
    std::vector<double> area;   ///< A of the last step
    std::vector<double> perimeter;  ///< L_C of the last step

    int cell_count() const { return static_cast<int>(first.size()) - 1; }
    int node_count() const { return first.back(); }
    int node_count(int cell) const { return first[cell + 1] - first[cell]; }
    Vec2 position(int node) const { return {x[node], y[node]}; }
    Vec2 velocity(int node) const { return {ux[node], uy[node]}; }
    Vec2 force(int node) const { return {fx[node], fy[node]}; }
};

/// A load per node or segment that a cell carries on from step to step, beside where it is; zero
/// where its kind has none.
struct CarriedLoad {
    const char* name;
    std::vector<double> Suspension::*values;
};
inline constexpr std::array carried_loads{
    CarriedLoad{"viscous_tension", &Suspension::viscous_tension},
    CarriedLoad{"viscous_moment", &Suspension::viscous_moment},
    CarriedLoad{"rigid_fx", &Suspension::rigid_fx}, CarriedLoad{"rigid_fy", &Suspension::rigid_fy}};

/// [begin, end) of the cells that are this thread's share, and of their nodes.
inline std::pair<int, int> own_cells(const Suspension& cells) {
    return team_share(cells.cell_count());
}
inline std::pair<int, int> own_nodes(const Suspension& cells) {
    const auto [begin, end] = own_cells(cells);
    return {cells.first[begin], cells.first[end]};
}

/// Calls f(cell) for each cell of this thread's share.
template <class F>
void for_own_cells(const Suspension& cells, F&& f) {
    const auto [begin, end] = own_cells(cells);
    for (int cell = begin; cell < end; ++cell) f(cell);
}

/// A read-only look at one cell's outline.
struct Outline {
    std::span<const double> x, y;
    int size() const { return static_cast<int>(x.size()); }
    Vec2 operator[](int k) const { return {x[k], y[k]}; }
};

inline Outline outline(const Suspension& cells, int cell) {
    const auto first = static_cast<std::size_t>(cells.first[cell]);
    const auto count = static_cast<std::size_t>(cells.node_count(cell));
    return {{cells.x.data() + first, count}, {cells.y.data() + first, count}};
}

/// Adds a cell whose nodes `points` are its stress-free shape: rest lengths and reference area are
/// those of the polygon, rest curvature that of its nodes. Precondition: at least 8 points,
/// counter-clockwise, simple.
void add_cell(Suspension& cells, const std::vector<Vec2>& points, int kind = 0);

/// Adds a copy of a cell of another suspension, moved, with the next id.
void copy_cell(const Suspension& from, int cell, Vec2 by, Suspension& to);

/// Takes a cell out; those after it move up, and keep their ids.
void remove_cell(Suspension& cells, int cell);

/// Numbers the cells from 0 on; none is led. After they were loaded.
void number_cells(Suspension& cells);

/// Gives the derived arrays their size: after the nodes were added or loaded.
void size_derived(Suspension& cells);

}  // namespace tt
