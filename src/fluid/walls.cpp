#include "fluid/walls.hpp"

#include <algorithm>
#include <cmath>

#include "fluid/wall_bins.hpp"
#include "grid/d2q9.hpp"

namespace tt {
namespace {

/// A site of the box for one of its surroundings; false beyond a wall of the lattice.
bool bring_home(const Lattice& lattice, int& i, int& j) {
    i = wrapped(i, lattice.nx);
    if (lattice.walls) return j >= 0 && j < lattice.ny;
    j = wrapped(j, lattice.ny);
    return true;
}

bool is_open_at(const Walls& walls, int i, int j) {
    return bring_home(walls.lattice, i, j) && walls.is_open(i, j);
}

template <class F>
void for_each_site(const Lattice& lattice, F&& f) {
    for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) f(i, j);
}

void open_by_parity(Walls& walls) {
    for (int j = 0; j < walls.lattice.ny; ++j) {
        const std::vector<double> crossings = crossings_of_row(walls.segments, j + 0.5);
        auto next = crossings.begin();
        for (int i = 0; i < walls.lattice.nx; ++i) {
            while (next != crossings.end() && *next < i + 0.5) ++next;
            const bool inside = (next - crossings.begin()) % 2 == 1;
            walls.open(i, j) = inside == walls.solid.outside ? 1 : 0;
        }
    }
}

/// Does a wall pass between two neighbours?
bool parted(const WallBins& bins, int i, int j, int x, int y) {
    return bins.first_meeting(Lattice::position(i, j), Lattice::position(x, y)).has_value();
}

/// Whether two neighbours on a diagonal with a wall between them are neighbours of an open third
/// without one: then it is the tip of a corner that they see each other through, and fluid goes
/// round it anyway.
bool around_a_tip(const WallBins& bins, const Walls& walls, int i, int j, int dx, int dy) {
    const auto joined = [&](int x, int y) {
        return is_open_at(walls, x, y) && !parted(bins, i, j, x, y) &&
               !parted(bins, x, y, i + dx, j + dy);
    };
    return dx != 0 && dy != 0 && (joined(i + dx, j) || joined(i, j + dy));
}

/// Of two open sites with a wall between them the one nearer to it is closed.
void close_thin_walls(const WallBins& bins, Walls& walls) {
    for_each_site(walls.lattice, [&](int i, int j) {
        for (int k = 1; k < d2q9::count; ++k) {
            if (!walls.is_open(i, j)) return;
            int x = i + d2q9::cx[k], y = j + d2q9::cy[k];
            const auto hit = bins.first_meeting(Lattice::position(i, j), Lattice::position(x, y));
            if (!hit || !is_open_at(walls, x, y) ||
                around_a_tip(bins, walls, i, j, d2q9::cx[k], d2q9::cy[k]))
                continue;
            bring_home(walls.lattice, x, y);
            (hit->share <= 0.5 ? walls.open(i, j) : walls.open(x, y)) = 0;
            ++walls.remarks.closed;
        }
    });
}

/// Sites of a connected part of what is open, side by side.
std::vector<std::pair<int, int>> part_of(const Walls& walls, int i, int j,
                                         Field<std::uint8_t>& seen) {
    std::vector<std::pair<int, int>> part{{i, j}};
    seen(i, j) = 1;
    for (std::size_t n = 0; n < part.size(); ++n) {
        for (int k = 1; k < 5; ++k) {
            int x = part[n].first + d2q9::cx[k], y = part[n].second + d2q9::cy[k];
            if (!bring_home(walls.lattice, x, y) || !walls.is_open(x, y) || seen(x, y)) continue;
            seen(x, y) = 1;
            part.push_back({x, y});
        }
    }
    return part;
}

/// Parts of less than a hundredth of the largest are pockets: noise in them would stay for ever.
void close_pockets(Walls& walls) {
    Field<std::uint8_t> seen(walls.lattice);
    std::vector<std::vector<std::pair<int, int>>> parts;
    std::size_t largest = 0;
    for_each_site(walls.lattice, [&](int i, int j) {
        if (!walls.is_open(i, j) || seen(i, j)) return;
        parts.push_back(part_of(walls, i, j, seen));
        largest = std::max(largest, parts.back().size());
    });
    for (const auto& part : parts) {
        if (100 * part.size() >= largest) {
            ++walls.remarks.parts;
            continue;
        }
        for (const auto& [i, j] : part) walls.open(i, j) = 0;
        walls.remarks.pockets += static_cast<int>(part.size());
    }
}

void fill_halo(Walls& walls) {
    const Lattice& lattice = walls.lattice;
    for (int j = -Lattice::halo; j < lattice.ny + Lattice::halo; ++j)
        for (int i = -Lattice::halo; i < lattice.nx + Lattice::halo; ++i)
            walls.open(i, j) = is_open_at(walls, i, j) ? 1 : 0;
}

void find_runs(Walls& walls) {
    const Lattice& lattice = walls.lattice;
    walls.first_run = {0};
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) {
            if (!walls.is_open(i, j)) continue;
            if (i > 0 && walls.is_open(i - 1, j))
                walls.runs.back().end = i + 1;
            else
                walls.runs.push_back({i, i + 1});
        }
        walls.first_run.push_back(static_cast<int>(walls.runs.size()));
    }
}

/// The part of c_k along an opening that faces (out_x, out_y).
std::pair<int, int> along_opening(const LatticeOpening& opening, int k) {
    return {opening.out_x == 0 ? d2q9::cx[k] : 0, opening.out_y == 0 ? d2q9::cy[k] : 0};
}

/// Which way the openings face, by the links straight through them.
void face_openings(const WallBins& bins, Walls& walls) {
    walls.openings.resize(walls.solid.openings.size());
    for_each_site(walls.lattice, [&](int i, int j) {
        if (!walls.is_open(i, j)) return;
        for (int k = 1; k < 5; ++k) {
            const int x = i - d2q9::cx[k], y = j - d2q9::cy[k];
            if (is_open_at(walls, x, y)) continue;
            const auto hit = bins.first_meeting(Lattice::position(i, j), Lattice::position(x, y));
            if (!hit || hit->opening < 0) continue;
            LatticeOpening& opening = walls.openings[hit->opening];
            const Opening& drawn = walls.solid.openings[hit->opening];
            if ((drawn.from.x == drawn.to.x) != (d2q9::cx[k] != 0)) continue;
            opening.out_x = -d2q9::cx[k];
            opening.out_y = -d2q9::cy[k];
            opening.off = hit->share - 0.5;
            ++opening.width;
        }
    });
}

/// Does the link come in through an opening? Where the site that its mirror image departs from is
/// closed it belongs to the wall.
bool enters(const Walls& walls, int i, int j, int k, int opening) {
    if (opening < 0) return false;
    const LatticeOpening& place = walls.openings[opening];
    if (place.out_x * d2q9::cx[k] + place.out_y * d2q9::cy[k] >= 0) return false;
    const auto [dx, dy] = along_opening(place, k);
    return is_open_at(walls, i - dx, j - dy);
}

void find_links(const WallBins& bins, Walls& walls) {
    const Lattice& lattice = walls.lattice;
    constexpr double smallest = 1e-9;
    face_openings(bins, walls);
    for_each_site(lattice, [&](int i, int j) {
        if (!walls.is_open(i, j)) return;
        for (int k = 1; k < d2q9::count; ++k) {
            const int x = i - d2q9::cx[k], y = j - d2q9::cy[k];
            if (is_open_at(walls, x, y)) continue;
            const auto hit = bins.first_meeting(Lattice::position(i, j), Lattice::position(x, y));
            if (hit && enters(walls, i, j, k, hit->opening)) {
                walls.inflow.push_back({i, j, k, hit->opening});
                continue;
            }
            WallLink link;
            link.i = i, link.j = j, link.direction = k;
            link.row_wall = lattice.walls && (y < 0 || y >= lattice.ny);
            // The lattice's own wall stands half-way, and is the pass's business alone.
            if (link.row_wall && !(hit && hit->share < 0.5)) continue;
            // Behind a site that was closed lies a thin wall, or none that this link meets.
            link.q = hit ? std::max(smallest, hit->share) : 1.0;
            link.loop = hit ? hit->loop : 0;
            link.second = is_open_at(walls, i + d2q9::cx[k], j + d2q9::cy[k]);
            if (!link.second) ++walls.remarks.single;
            walls.links.push_back(link);
        }
    });
    std::stable_sort(walls.links.begin(), walls.links.end(),
                     [](const WallLink& a, const WallLink& b) { return a.loop < b.loop; });
    std::stable_sort(
        walls.inflow.begin(), walls.inflow.end(),
        [](const OpeningLink& a, const OpeningLink& b) { return a.opening < b.opening; });
}

}  // namespace

std::int64_t Walls::open_sites() const {
    std::int64_t count = 0;
    for (const OpenRun& run : runs) count += run.end - run.begin;
    return count;
}

double Walls::sampled_flow() const {
    double excess = 0.0;
    for (const LatticeOpening& opening : openings)
        excess += 0.5 / std::pow(std::max(1, opening.width), 2);
    return openings.empty() ? 1.0 : 1.0 + excess / static_cast<double>(openings.size());
}

Walls make_walls(const Solid& solid, const Lattice& lattice) {
    Walls walls;
    walls.lattice = lattice;
    walls.solid = solid;
    walls.segments = segments_near(solid, lattice.nx, lattice.ny, Lattice::halo + 1.0);
    walls.open = Field<std::uint8_t>(lattice);
    const WallBins bins(walls.segments, lattice);
    open_by_parity(walls);
    close_thin_walls(bins, walls);
    close_pockets(walls);
    fill_halo(walls);
    find_runs(walls);
    find_links(bins, walls);
    measure_distances(bins, walls);
    return walls;
}

}  // namespace tt
