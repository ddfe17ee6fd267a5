#pragma once

#include <cmath>

namespace tt {

/// Exponents of kilogram, metre and second. An angle has its own, so that "30 %" is no angle.
struct Dimension {
    int kg = 0;
    int m = 0;
    int s = 0;
    int rad = 0;
    friend constexpr bool operator==(Dimension, Dimension) = default;
};

/// A number in SI units whose dimension is part of its type. The simulation is two-dimensional per
/// metre of depth, but quantities keep their three-dimensional dimension: a tension is N/m, a
/// density kg/m³.
template <Dimension D>
struct Quantity {
    static constexpr Dimension dimension = D;
    double si = 0.0;
    friend constexpr auto operator<=>(Quantity, Quantity) = default;
};

using Length = Quantity<Dimension{0, 1, 0}>;
using Angle = Quantity<Dimension{0, 0, 0, 1}>;
using Area = Quantity<Dimension{0, 2, 0}>;
using Time = Quantity<Dimension{0, 0, 1}>;
using Rate = Quantity<Dimension{0, 0, -1}>;
using InverseLength = Quantity<Dimension{0, -1, 0}>;
using Velocity = Quantity<Dimension{0, 1, -1}>;
using Acceleration = Quantity<Dimension{0, 1, -2}>;
using Density = Quantity<Dimension{1, -3, 0}>;
using Viscosity = Quantity<Dimension{1, -1, -1}>;
using KinematicViscosity = Quantity<Dimension{0, 2, -1}>;
using Pressure = Quantity<Dimension{1, -1, -2}>;
using PressureGradient = Quantity<Dimension{1, -2, -2}>;
using Tension = Quantity<Dimension{1, 0, -2}>;           ///< N/m; also an energy per area, J/m²
using BendingModulus = Quantity<Dimension{1, 2, -2}>;    ///< N m
using SurfaceViscosity = Quantity<Dimension{1, 0, -1}>;  ///< N s/m, of a membrane's stretching
using BendingViscosity = Quantity<Dimension{1, 2, -1}>;  ///< N m s, of its bending
using Power = Quantity<Dimension{1, 1, -3}>;             ///< W/m: per depth
using SurfaceEnergy = Tension;

/// The one place where SI and lattice units meet: the SI value of one lattice unit of length, time
/// and mass. A lattice value is si / (mass^kg · length^m · time^s), whatever the quantity.
struct Scales {
    double length = 1.0;  ///< site spacing h [m]
    double time = 1.0;    ///< time step Δt [s]
    double mass = 1.0;    ///< ρ h³ [kg], with ρ the density that the simulation runs at

    /// SI value of one lattice unit of dimension `d`.
    double unit(Dimension d) const {
        return std::pow(mass, d.kg) * std::pow(length, d.m) * std::pow(time, d.s);
    }
    template <Dimension D>
    double to_lattice(Quantity<D> q) const {
        return q.si / unit(D);
    }
    template <class Q>
    Q to_si(double lattice) const {
        return Q{lattice * unit(Q::dimension)};
    }
};

}  // namespace tt
