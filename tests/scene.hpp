#pragma once

#include <variant>
#include <vector>

#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt::test {

/// A model and a state put together by hand, plasma everywhere, nothing moving.
struct Scene {
    Model model;
    State state;

    explicit Scene(Lattice lattice) {
        model.lattice = lattice;
        model.scales = {2e-7, 1e-6, 1025.0 * 8e-21};
        model.viscosity.plasma = 1.0 / 6.0;
        model.kinds[0].membrane.in_plane = NeoHookean{0.01};
        state.sites = Sites<double>(lattice);
        sites().relaxation.even.fill(even_rate(model.viscosity.plasma));
    }

    Sites<double>& sites() { return std::get<Sites<double>>(state.sites); }

    /// Velocity u(position) on every site.
    template <class U>
    void set_velocity(U u) {
        for (int j = 0; j < model.lattice.ny; ++j) {
            for (int i = 0; i < model.lattice.nx; ++i) {
                const Vec2 v = u(Lattice::position(i, j));
                sites().velocity.x(i, j) = v.x;
                sites().velocity.y(i, j) = v.y;
            }
        }
    }

    /// Velocity u(position) on every node.
    template <class U>
    void set_node_velocity(U u) {
        for (int n = 0; n < state.cells.node_count(); ++n) {
            const Vec2 v = u(state.cells.position(n));
            state.cells.ux[n] = v.x;
            state.cells.uy[n] = v.y;
        }
    }

    void add(const std::vector<Vec2>& points) { add_cell(state.cells, points); }
};

}  // namespace tt::test
