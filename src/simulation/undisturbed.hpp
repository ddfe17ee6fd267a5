#pragma once

#include <span>
#include <vector>

#include "fluid/ports.hpp"
#include "fluid/section_line.hpp"
#include "fluid/walls.hpp"
#include "grid/field.hpp"

namespace tt {

/// The steady flow of plasma alone, without inertia, between walls of any shape, driven by a force
/// along x; and, where y is periodic, by as much along y as makes the mean flow go along x: an
/// array of posts that leans would turn it aside. Or driven by ports. In units in which its mean
/// velocity along x, over all of the box, is 1 and so is a site.
struct UndisturbedFlow {
    VectorField<> velocity;
    Field<> density;  ///< deviation times viscosity, p = ρ/3: what varies about the mean drop
    double conductance = 0.0;  ///< Q ν/g of flow rate and force; ny³/12 of a straight channel
    double lean = 0.0;         ///< force along y over that along x
    double site_mean = 1.0;    ///< mean of u_x over all sites, a little off the mean velocity
    double fastest = 0.0;      ///< largest speed
    double steepest = 0.0;     ///< largest shear rate at the walls
    /// Of a network, whose unit of velocity is that of what its ports hold.
    struct Port {
        double inflow = 0.0, density = 0.0;  ///< as `density` above
    };
    std::vector<Port> ports;
    /// The same of lines across channels; where a force drives the flow, with the drop of pressure
    /// that it stands for.
    std::vector<SectionReading> sections;
};

/// What the sum of u_x over the sites lacks of nx times the flow rate: beside a wall at the share q
/// of a spacing, with a velocity that grows linearly from it, a column of sites leaves out, or
/// counts twice, u′ ((q − ½)²/2 − 1/24).
template <class Real>
double flow_beside_walls(const Walls& walls, const Field<Real>& ux);

/// Of channels between ports; `conditions` as if the viscosity were 1, so that densities are those
/// of the model over its viscosity.
UndisturbedFlow undisturbed_flow(const Walls& walls, const std::vector<PortCondition>& conditions,
                                 std::span<const SectionLine> sections, int threads);

/// Computes it on as many threads, from rest until the flow rate changes no more (to 10⁻⁵).
/// Fields are means of two steps, of which the lattice's staggered momentum is taken off.
UndisturbedFlow undisturbed_flow(const Walls& walls, std::span<const SectionLine> sections,
                                 int threads);

}  // namespace tt
