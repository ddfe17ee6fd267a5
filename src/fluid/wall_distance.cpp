#include <algorithm>
#include <cmath>

#include "fluid/wall_bins.hpp"
#include "fluid/walls.hpp"

namespace tt {

/// Each site takes the nearest of the walls that are nearest to its neighbours, in sweeps to and
/// fro.
void measure_distances(const WallBins& bins, Walls& walls) {
    const Lattice& lattice = walls.lattice;
    constexpr int halo = Lattice::halo;
    Field<std::int32_t> nearest(lattice, -1);
    walls.distance = Field<double>(lattice, HUGE_VAL);
    const auto consider = [&](int i, int j, std::int32_t segment) {
        if (segment < 0 || walls.segments[segment].opening >= 0) return;
        const Vec2 here = Lattice::position(i, j);
        const double away = norm(here - nearest_on(walls.segments[segment], here));
        if (away >= walls.distance(i, j)) return;
        walls.distance(i, j) = away;
        nearest(i, j) = segment;
    };
    const auto for_each = [&](auto&& f) {
        for (int j = -halo; j < lattice.ny + halo; ++j)
            for (int i = -halo; i < lattice.nx + halo; ++i) f(i, j);
    };
    for_each([&](int i, int j) {
        bins.for_each_near(Lattice::position(i, j), [&](int s) { consider(i, j, s); });
    });
    const auto look = [&](int i, int j, int di, int dj) {
        const int x = i + di, y = j + dj;
        if (x < -halo || x >= lattice.nx + halo || y < -halo || y >= lattice.ny + halo) return;
        consider(i, j, nearest(x, y));
    };
    const int width = lattice.nx + 2 * halo, height = lattice.ny + 2 * halo;
    for (int sweep = 0; sweep < 4; ++sweep) {
        const bool up = sweep % 2 == 0, right = sweep / 2 == 0;
        for (int n = 0; n < height; ++n) {
            for (int m = 0; m < width; ++m) {
                const int i = right ? m - halo : lattice.nx + halo - 1 - m;
                const int j = up ? n - halo : lattice.ny + halo - 1 - n;
                const int a = right ? -1 : 1, b = up ? -1 : 1;
                look(i, j, a, 0), look(i, j, 0, b), look(i, j, a, b), look(i, j, -a, b);
            }
        }
    }
    for_each([&](int i, int j) {
        double& away = walls.distance(i, j);
        if (lattice.walls) away = std::min(away, std::min(j + 0.5, lattice.ny - (j + 0.5)));
        if (!walls.is_open(i, j)) away = -std::fabs(away);
    });
}

double Walls::distance_at(Vec2 place) const {
    const double x = place.x - lattice.nx * std::floor(place.x / lattice.nx) - 0.5;
    const double y = lattice.walls ? place.y - 0.5
                                   : place.y - lattice.ny * std::floor(place.y / lattice.ny) - 0.5;
    const int i = static_cast<int>(std::floor(x));
    const int j =
        std::clamp(static_cast<int>(std::floor(y)), -Lattice::halo, lattice.ny + Lattice::halo - 2);
    const double a = x - i, b = y - j;
    return (1.0 - b) * ((1.0 - a) * distance(i, j) + a * distance(i + 1, j)) +
           b * ((1.0 - a) * distance(i, j + 1) + a * distance(i + 1, j + 1));
}

Vec2 Walls::away_at(Vec2 place) const {
    constexpr double step = 0.5;
    const Vec2 slope{distance_at(place + Vec2{step, 0.0}) - distance_at(place - Vec2{step, 0.0}),
                     distance_at(place + Vec2{0.0, step}) - distance_at(place - Vec2{0.0, step})};
    const double size = norm(slope);
    return size > 0.0 ? slope / size : Vec2{};
}

}  // namespace tt
