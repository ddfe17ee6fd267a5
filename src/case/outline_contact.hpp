#pragma once

#include <optional>

#include "base/vec2.hpp"

namespace tt {

/// An outline as a closed polygon: edge k starts at node k.
struct Edges {
    const double *x, *y;            ///< nodes
    const double *edge_x, *edge_y;  ///< to the next node
    const double* inverse;          ///< 1 / (length of the edge)²
    int count;                      ///< at most `most`
    static constexpr int most = 32;

    Vec2 node(int k) const { return {x[k], y[k]}; }
    Vec2 edge(int k) const { return {edge_x[k], edge_y[k]}; }
};

/// A point of an outline that is pressed, and by how much it would have to move.
struct Push {
    int edge = 0;        ///< that it lies on
    double along = 0.0;  ///< at this share of it
    Vec2 move;
};

/// What presses on `outline` at its point nearest to `point`, if that is nearer than `gap` outside
/// or anywhere inside: the way back to a distance of `gap`.
std::optional<Push> push_from(const Edges& outline, Vec2 point, double gap);

}  // namespace tt
