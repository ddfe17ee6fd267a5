#pragma once

#include <cstdint>
#include <vector>

#include "base/vec2.hpp"
#include "geometry/loops.hpp"
#include "grid/field.hpp"

namespace tt {

/// Sites [begin, end) of a row, all of them open.
struct OpenRun {
    int begin, end;
};

/// A population that departs from site (i, j) into a wall and comes back along c_direction.
struct WallLink {
    int i = 0, j = 0, direction = 0;
    double q = 0.5;         ///< distance of the wall along the link, 0 … 1
    int loop = 0;           ///< of the wall
    bool second = true;     ///< the site behind, x + c, is open as well
    bool row_wall = false;  ///< x − c lies beyond a wall of the lattice itself
    Vec2 velocity;          ///< of the wall
};

/// A population that enters site (i, j) along c_direction through an opening. Its mirror image in
/// the opening departs from the open site (i, j) − c_t, with c_t the part of c along the opening.
struct OpeningLink {
    int i = 0, j = 0, direction = 0;
    int opening = 0;
};

/// Where fluid goes in and out, on the lattice.
struct LatticeOpening {
    int out_x = 0, out_y = 0;  ///< direction out of the fluid; 0, 0: no site is beside it
    int width = 0;             ///< sites beside it
    double off = 0.0;          ///< from half-way between two sites, outwards [sites]
};

/// What had to be done to a drawing to put it on the lattice, and how fine that is.
struct WallRemarks {
    int closed = 0;   ///< open sites that were closed, as a wall beside them is thinner than a site
    int pockets = 0;  ///< open sites that are cut off from the rest, closed
    int parts = 0;    ///< that are not connected, pockets left aside
    int single = 0;   ///< links with one open site, where the wall is taken as half-way
};

/// Walls of any shape on a lattice: which sites are open to the fluid, and the links that the walls
/// cut. Sites are open or not by the even–odd rule. Nothing passes through a wall, however thin:
/// where one stands between two open neighbours the nearer of them is closed, but for the tip of a
/// corner between two neighbours on a diagonal that fluid goes round.
struct Walls {
    Lattice lattice;
    Solid solid;  ///< as drawn, in sites
    std::vector<WallSegment> segments;
    Field<std::uint8_t> open;    ///< 1 or 0; the halo too
    std::vector<int> first_run;  ///< of each row, and the end
    std::vector<OpenRun> runs;
    std::vector<WallLink> links;           ///< by loop, then by row and column
    std::vector<OpeningLink> inflow;       ///< by opening, then by row and column
    std::vector<LatticeOpening> openings;  ///< of the solid, in its order
    /// To the nearest wall, those of the lattice included, openings not [sites]; negative in the
    /// solid; the halo too. Between sites to be interpolated.
    Field<double> distance;
    WallRemarks remarks;

    /// By how much what passes ports, a sum over the sites across, is more than the flow rate, the
    /// integral: 1 + 1/(2 H²) of a parabola over H sites, the mean of all ports, so that what goes
    /// in still comes out. 1 without ports.
    double sampled_flow() const;

    bool is_open(int i, int j) const { return open(i, j) != 0; }
    std::int64_t open_sites() const;
    /// Distance to the nearest wall, and the direction away from it, at any place. Bilinear between
    /// sites: exact beside straight walls.
    double distance_at(Vec2 place) const;
    Vec2 away_at(Vec2 place) const;
};

/// Puts `solid` (in sites) on the lattice. Its periods are those of the lattice.
Walls make_walls(const Solid& solid, const Lattice& lattice);

}  // namespace tt
