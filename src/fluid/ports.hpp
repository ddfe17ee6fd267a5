#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "fluid/populations.hpp"
#include "fluid/walls.hpp"
#include "grid/field.hpp"

namespace tt {

/// What an opening of the walls holds. Lattice units.
struct HeldDensity {
    double deviation = 0.0;  ///< δρ = p / c_s²
    friend bool operator==(const HeldDensity&, const HeldDensity&) = default;
};
struct HeldInflow {
    double rate = 0.0;  ///< volume per step into the fluid; negative: out of it
    friend bool operator==(const HeldInflow&, const HeldInflow&) = default;
};
using PortCondition = std::variant<HeldDensity, HeldInflow>;

/// What went on at a port in the last step and in the one before: their mean is free of what a
/// lattice conserves besides momentum, which changes sign from step to step.
struct PortFlow {
    std::array<double, 2> density{}, inflow{};

    double mean_density() const { return 0.5 * (density[0] + density[1]); }
    double mean_inflow() const { return 0.5 * (inflow[0] + inflow[1]); }
    friend bool operator==(const PortFlow&, const PortFlow&) = default;
};

/// What comes in through openings along the axes that lie half-way between two sites: anti-specular
/// links. With m the mirror image of i in the opening, c_t the part of c_i along it and g what
/// departs,
///
///     f_i(x) = −g_m(x − c_t) + 2 w_i δρ + 6 w_i u_n²,
///
/// the last where the equilibrium has inertia: uniform pressure on the opening, no velocity along
/// it. Exact in Poiseuille flow, for any relaxation times; anti-bounce-back, which takes −g of the
/// opposite direction, holds the shear along the opening at zero and is off. Where the inflow
/// Q is held, δρ is what gives it in this step:
///
///     δρ = (Q + 2 Σ g_m − Σ 6 w_i u_n²) / (2 Σ w_i).
///
/// In place as walls are (docs/theory/ports.md): after an even pass the source is slot m̄ of x − c_t
/// and the target slot ī of x − c_i; after an odd one slot m of the site beyond x, and slot i of x.
/// No target is a source, and none is touched by links of walls.
template <class Real = double>
class Ports {
public:
    Ports() = default;
    Ports(const Walls& walls, const Populations<Real>& populations);

    bool empty() const { return ports_.empty(); }

    /// After a pass in the phase that the populations still have; what it left lies in the box, not
    /// in the halo. `velocity` is that of the pass where the equilibrium has inertia, else nullptr.
    /// One thread; all rows have been passed.
    void apply(const std::vector<PortCondition>& conditions, const VectorField<Real>* velocity,
               Populations<Real>& populations, std::vector<PortFlow>& flow) const;

private:
    struct Link {
        std::uint32_t even_source, even_target, odd_source, odd_target;
        int i, j;
        Real weight;
    };
    struct Port {
        std::vector<Link> links;
        bool across_x = false;  ///< it faces along x
        double weight = 0.0;    ///< Σ w
    };
    std::vector<Port> ports_;
};

}  // namespace tt
