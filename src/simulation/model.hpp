#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "coupling/delta/delta.hpp"
#include "coupling/jump.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/boundaries.hpp"
#include "fluid/equilibrium.hpp"
#include "grid/field.hpp"
#include "grid/lattice.hpp"
#include "interaction/contact.hpp"
#include "membrane/forces.hpp"
#include "simulation/exits.hpp"
#include "simulation/feed.hpp"
#include "simulation/sections.hpp"
#include "simulation/undisturbed.hpp"
#include "simulation/waveform.hpp"

namespace tt {

/// How the flow is driven and held. Lattice units.
struct Drive {
    double body_force =
        0.0;  ///< uniform, along x; the controller's first guess when it holds the mean velocity
    /// Of the force: along x, or turned such that the mean flow goes along x; of a feed along it.
    Vec2 direction{1.0, 0.0};
    Waveform waveform;   ///< of the force
    double width = 0.0;  ///< across which momentum spreads; 0: that of the box
    bool hold_mean_velocity = false;
    double target_velocity =
        0.0;  ///< mean velocity to hold, or the nominal one; of a network the unit of `undisturbed`
};

/// What cells of one kind have in common; their cytoplasm is in ViscosityModel. Lattice units.
struct CellKind {
    std::string name;  ///< empty where there is but one
    Membrane membrane;
    JumpCorrection jump;
};

/// Everything that does not change during a run. Lattice units; `scales` leads back to SI.
struct Model {
    Lattice lattice;
    Scales scales;
    double density_scale =
        1.0;  ///< S: how much the simulated density, and with it the Reynolds number, is raised
    Equilibrium equilibrium;
    Precision precision = Precision::fp64;  ///< of what the sites hold
    Boundaries boundaries;
    std::vector<std::string> port_names;  ///< of boundaries.ports
    std::vector<Waveform> port_waves;     ///< of what they hold; none: all steady
    std::vector<Exit> exits;              ///< the same ports, as cells meet them
    std::vector<Feed> feeds;              ///< of those through which cells come
    std::vector<Section> sections;        ///< where something is measured
    std::vector<Fork> forks;              ///< of these
    std::vector<Stretch> stretches;
    Vec2 origin;  ///< of the box, in the coordinates of the drawing
    Drive drive;
    ViscosityModel viscosity;
    Delta delta;
    std::vector<CellKind> kinds{1};  ///< of cells
    ContactModel contact;
    double shear_rate =
        0.0;  ///< nominal k: wall shear rate, or pseudo-shear rate of a channel [1/step]
    int threads = 1;
    /// Of plasma alone between walls of any shape; none of a straight channel.
    std::shared_ptr<const UndisturbedFlow> undisturbed;

    const CellKind& kind_of(const Suspension& cells, int cell) const {
        return kinds[static_cast<std::size_t>(cells.kind[cell])];
    }
    /// Whether the membrane of any kind has dipoles.
    bool has_dipoles() const {
        return std::any_of(kinds.begin(), kinds.end(),
                           [](const CellKind& kind) { return kind.jump.has_dipole(); });
    }
    /// Q ν/g of plasma alone.
    double conductance() const {
        const double height = lattice.ny;
        return undisturbed ? undisturbed->conductance : height * height * height / 12.0;
    }
    /// Of the sites that hold fluid.
    double open_area() const {
        return boundaries.walls ? static_cast<double>(boundaries.walls->open_sites())
                                : static_cast<double>(lattice.nx) * lattice.ny;
    }
};

}  // namespace tt
