#include "observe/plasma_map.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "membrane/shapes.hpp"

namespace tt {
namespace {

constexpr Vec2 axes{9.0, 4.0};
constexpr double tilt = 0.4;

/// Two ellipses, the first across the ends of the box and, where it has no walls, its rows as well.
Suspension two_ellipses(const Lattice& box) {
    Suspension cells;
    for (const Vec2 centre : {Vec2{-1.3, box.walls ? 12.2 : -0.6}, Vec2{13.1, 9.7}})
        add_cell(cells, placed(ellipse(axes.x, axes.y, 80), tilt, centre));
    return cells;
}

/// Of a site and a cell's node or centre, along one axis: the shortest way, around the box.
double around(double way, int period) { return way - period * std::round(way / period); }

bool near_membrane(const Lattice& box, const Suspension& cells, int cell, int i, int j) {
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        const double dx = around(i + 0.5 - cells.x[n], box.nx);
        const double dy = box.walls ? j + 0.5 - cells.y[n] : around(j + 0.5 - cells.y[n], box.ny);
        if (dx > -2.0 && dx <= 2.0 && dy > -2.0 && dy <= 2.0) return true;
    }
    return false;
}

/// (x/a)² + (y/b)² in the ellipse's own axes: below 1 inside.
double ellipse_form(const Lattice& box, const Suspension& cells, int cell, int i, int j) {
    Vec2 centre;
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n)
        centre += cells.position(n) / cells.node_count(cell);
    const double x = around(i + 0.5 - centre.x, box.nx);
    const double y = box.walls ? j + 0.5 - centre.y : around(j + 0.5 - centre.y, box.ny);
    const double along = std::cos(tilt) * x + std::sin(tilt) * y;
    const double across = std::cos(tilt) * y - std::sin(tilt) * x;
    return along * along / (axes.x * axes.x) + across * across / (axes.y * axes.y);
}

TEST(PlasmaMap, is_what_each_site_says_for_itself_on_any_number_of_threads) {
    for (const Lattice& box : {Lattice{41, 26, true}, Lattice{41, 26, false}}) {
        const Suspension cells = two_ellipses(box);
        for (const int threads : {1, 3}) {
            PlasmaMap map(box);
            with_team(threads, [&] { map.mark(cells); });
            int clear = 0;
            for (int j = 0; j < box.ny; ++j) {
                for (int i = 0; i < box.nx; ++i) {
                    const double form = std::min(ellipse_form(box, cells, 0, i, j),
                                                 ellipse_form(box, cells, 1, i, j));
                    if (std::abs(form - 1.0) < 0.02) continue;  // the outline is a polygon
                    for (const int cell : {0, 1}) {
                        const bool expected =
                            form > 1.0 && !near_membrane(box, cells, 1 - cell, i, j);
                        EXPECT_EQ(map.clear_of_others(i, j, cell), expected)
                            << i << ' ' << j << " cell " << cell;
                        clear += expected ? 1 : 0;
                    }
                }
            }
            EXPECT_GT(clear, 200);
        }
    }
}

TEST(PlasmaMap, is_clear_around_a_place_where_all_twelve_sites_are_that_will_be_read) {
    for (const Lattice& box : {Lattice{41, 26, true}, Lattice{41, 26, false}}) {
        const PlasmaMap map(box, two_ellipses(box));
        const auto clear = [&](int i, int j) {
            if (box.walls && (j < 0 || j >= box.ny)) return true;
            return map.clear_of_others(wrapped(i, box.nx), wrapped(j, box.ny), 0);
        };
        int clear_places = 0;
        for (int j = -1; j <= box.ny; ++j) {
            for (int i = -50; i < 60; ++i) {
                bool all = true;
                for (int dj = -1; dj <= 2; ++dj) {
                    for (int di = -1; di <= 2; ++di) {
                        const bool corner = (dj == -1 || dj == 2) && (di == -1 || di == 2);
                        all = all && (corner || clear(i + di, j + dj));
                    }
                }
                EXPECT_EQ(map.clear_around(i, j, 0), all) << i << ' ' << j;
                clear_places += all ? 1 : 0;
            }
        }
        EXPECT_GT(clear_places, 100);
    }
}

}  // namespace
}  // namespace tt
