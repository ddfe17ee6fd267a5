#pragma once

#include <vector>

#include "fluid/populations.hpp"
#include "fluid/walls.hpp"
#include "grid/field.hpp"

namespace tt {

/// A line across a channel, along an axis and half-way between two columns or rows of sites. Of an
/// upright line, x = plane, these are the columns plane − 1 and plane; what goes along +x passes it
/// forward where `sign` is 1, backward where it is −1. Of a level line the same of y. Sites.
struct SectionLine {
    bool upright = true;
    int plane = 0;
    int sign = 1;
    double begin = 0.0, end = 0.0;  ///< from wall to wall, of the coordinate along it
    /// A population that steps forward over the line, from an open site to the open site (i, j).
    struct Link {
        int i = 0, j = 0, direction = 0;
    };
    std::vector<Link> links;
    std::vector<int> rows;  ///< along it: where the sites on both sides are open

    double width() const { return end - begin; }
    Vec2 place(double along) const {
        return upright ? Vec2{static_cast<double>(plane), along}
                       : Vec2{along, static_cast<double>(plane)};
    }
    Vec2 middle() const { return place(0.5 * (begin + end)); }
};

/// The line through `plane` between `begin` and `end`, its links and rows. `walls` may be none:
/// then all sites are open.
SectionLine section_line(const Lattice& lattice, const Walls* walls, bool upright, int plane,
                         double begin, double end);

/// What passed a line in the last step, and the density on it.
struct SectionReading {
    double inflow = 0.0;   ///< mass, which is volume: Σ (f_i − f_ī) over the links; forward
    double density = 0.0;  ///< deviation, mean of the line
};

/// Mass passes a line on the links that cross it, and on no other way: so what passes any line
/// across a channel is the same once the flow is steady, wherever the walls lie between sites. The
/// sum of u over the sites is not: it misses, or counts twice, what lies beside the walls. In phase
/// odd the halo must be filled.
template <class Real>
SectionReading read_section(const SectionLine& line, const Populations<Real>& populations);

/// Velocity through the line, forward, at each of its rows: the mean of the sites on both sides.
template <class Real>
void read_velocity(const SectionLine& line, const VectorField<Real>& velocity,
                   std::vector<double>& result);

}  // namespace tt
