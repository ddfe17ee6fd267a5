#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "membrane/shapes.hpp"
#include "membrane/suspension.hpp"

namespace tt::random_cells {

/// A smooth star-shaped outline about the origin, counter-clockwise: radius · (1 + Σ of four
/// harmonics), up to 60 % off the circle, squeezed along a random axis down to `thinnest` of its
/// width.
inline std::vector<Vec2> smooth_shape(Random& random, double radius, int nodes,
                                      double thinnest = 0.3) {
    double amplitude[4], phase[4];
    for (int m = 0; m < 4; ++m) {
        amplitude[m] = random.uniform(0.0, 0.15);
        phase[m] = random.uniform(0.0, 2.0 * std::numbers::pi);
    }
    const double squeeze = random.uniform(thinnest, 1.0);
    std::vector<Vec2> points(nodes);
    for (int k = 0; k < nodes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / nodes;
        double r = 1.0;
        for (int m = 0; m < 4; ++m) r += amplitude[m] * std::cos((m + 2) * angle + phase[m]);
        points[k] = {radius * r * std::cos(angle), squeeze * radius * r * std::sin(angle)};
    }
    return placed(points, random.uniform(0.0, 2.0 * std::numbers::pi), {0.0, 0.0});
}

/// `columns` × `rows` smooth shapes on a jittered grid of the given pitch, turned at random, each
/// shifted by a random number of periods so that unwrapped positions are met.
inline Suspension suspension(std::uint64_t seed, int columns, int rows, double pitch, double radius,
                             int nodes) {
    Random random(seed);
    Suspension cells;
    const double period = columns * pitch;
    for (int c = 0; c < columns; ++c) {
        for (int r = 0; r < rows; ++r) {
            const double turns = std::floor(random.uniform(-2.0, 3.0));
            const Vec2 centre{(c + random.uniform(0.3, 0.7)) * pitch + turns * period,
                              (r + random.uniform(0.4, 0.6)) * pitch};
            add_cell(cells, placed(smooth_shape(random, radius, nodes), 0.0, centre));
        }
    }
    return cells;
}

/// Moves every node by up to `step` along each axis, and every cell by up to ten times as much.
inline void jiggle(Suspension& cells, Random& random, double step) {
    for (int c = 0; c < cells.cell_count(); ++c) {
        const Vec2 shift{random.uniform(-10.0, 10.0) * step, random.uniform(-10.0, 10.0) * step};
        for (int k = cells.first[c]; k < cells.first[c + 1]; ++k) {
            cells.x[k] += shift.x + random.uniform(-step, step);
            cells.y[k] += shift.y + random.uniform(-step, step);
        }
    }
}

}  // namespace tt::random_cells
