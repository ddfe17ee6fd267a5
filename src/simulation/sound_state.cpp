#include "simulation/sound_state.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "io/archive.hpp"
#include "simulation/state_arrays.hpp"

namespace tt {
namespace {

/// The fewest nodes of a cell, as `add_cell` asks.
constexpr std::int32_t fewest_nodes = 8;

/// Positions are unwrapped; a cell that has gone round a billion sites is none of ours.
constexpr double farthest = 1e9;

void expect_cells(const Suspension& cells) {
    if (cells.first.empty() || cells.first.front() != 0)
        refuse_checkpoint("its list of cells is wrong");
    for (std::size_t c = 1; c < cells.first.size(); ++c) {
        const std::int64_t nodes = std::int64_t{cells.first[c]} - cells.first[c - 1];
        if (nodes < fewest_nodes) refuse_checkpoint("its list of cells is wrong");
    }
}

void expect_sizes(const State& state) {
    const Suspension& cells = state.cells;
    const auto nodes = static_cast<std::size_t>(cells.node_count());
    const auto expect_size = [&](const std::vector<double>& per_node) {
        if (per_node.size() != nodes) refuse_checkpoint("an array is not of one number per node");
    };
    for (const auto* per_node :
         {&cells.x, &cells.y, &cells.fx, &cells.fy, &cells.pair_fx, &cells.pair_fy, &cells.ux,
          &cells.uy, &cells.ux_sampled, &cells.uy_sampled, &cells.rest_curvature,
          &cells.rest_length, &state.interior.x, &state.interior.y})
        expect_size(*per_node);
    for (const CarriedLoad& load : carried_loads) expect_size(cells.*load.values);
    const auto count = static_cast<std::size_t>(cells.cell_count());
    bool sized = cells.kind.size() == count;
    for (const auto* per_cell : {&cells.reference_area, &cells.reference_perimeter, &cells.alpha,
                                 &cells.area, &cells.perimeter}) {
        sized = sized && per_cell->size() == count;
    }
    if (!sized) refuse_checkpoint("an array is not of one number per cell");
}

/// Every number of the cells and of the drive is finite; `smallest_gap` alone may be nan.
void expect_finite(const State& state) {
    const auto expect = [](const char* name, const auto& values) {
        for (const auto value : values) {
            if (!std::isfinite(static_cast<double>(value)))
                refuse_checkpoint(fmt::format("'{}' holds a number that is not finite", name));
        }
    };
    for_each_array(state, expect);
    for (const CarriedLoad& load : carried_loads) expect(load.name, state.cells.*load.values);
    if (state.step < 0) refuse_checkpoint("its step is negative");
    if (!std::isfinite(state.drive.body_force) || !std::isfinite(state.drive.integral))
        refuse_checkpoint("its drive is not finite");
}

void expect_kinds(int kinds, const Suspension& cells) {
    for (const std::int32_t kind : cells.kind)
        if (kind < 0 || kind >= kinds) refuse_checkpoint("a cell is of a kind that is not there");
}

/// Every node stands where the lattice can be asked for it: between the walls, and each cell within
/// a stretch that a membrane can have.
void expect_places(const Lattice& lattice, const Suspension& cells) {
    const double longest = 4.0 * (lattice.nx + lattice.ny);
    for (int c = 0; c < cells.cell_count(); ++c) {
        const Vec2 start = cells.position(cells.first[c]);
        for (int n = cells.first[c]; n < cells.first[c + 1]; ++n) {
            const Vec2 p = cells.position(n);
            if (std::abs(p.x) > farthest || std::abs(p.y) > farthest || norm(p - start) > longest)
                refuse_checkpoint("a node is far from its cell");
            if (lattice.walls && !(p.y > 0.0 && p.y < lattice.ny))
                refuse_checkpoint("a node is beyond a wall");
        }
    }
}

}  // namespace

void refuse_checkpoint(std::string_view why) {
    throw DamagedArchive(fmt::format("the checkpoint cannot be loaded: {}", why));
}

void expect_sound(const Model& model, const State& state) {
    const Lattice& lattice = model.lattice;
    expect_cells(state.cells);
    expect_sizes(state);
    expect_kinds(static_cast<int>(model.kinds.size()), state.cells);
    expect_finite(state);
    expect_places(lattice, state.cells);
    for (std::size_t n = 0; n < state.cells.x.size(); ++n) {
        if (std::abs(state.interior.x[n]) > farthest || std::abs(state.interior.y[n]) > farthest)
            refuse_checkpoint("the cytoplasm was laid far from its cell");
    }
}

}  // namespace tt
