#pragma once

#include <array>
#include <cstdint>
#include <functional>
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
/// What arrives at the end of a channel on another lattice, whose sites are these moved.
struct FedInflow {
    int feed = 0;      ///< which channel
    int i = 0, j = 0;  ///< site here that is (0, 0) there
    friend bool operator==(const FedInflow&, const FedInflow&) = default;
};
using PortCondition = std::variant<HeldDensity, HeldInflow, FedInflow>;

/// The populations of a channel that feeds, after the same pass as here and settled.
template <class Real>
using FeedPopulations = std::function<const Populations<Real>&(int feed)>;

/// What went on at a port in the last step and in the one before: their mean is free of what a
/// lattice conserves besides momentum, which changes sign from step to step.
struct PortFlow {
    std::array<double, 2> density{}, inflow{};
    double factor = 1.0;  ///< of what the port holds in the coming step

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
/// What is fed comes in as it arrives at the end of the other channel, h_i, and all of it with the
/// one density more that lets as much in as passes there, whatever departs here:
///
///     f_i(x) = h_i(x) + w_i δ,   δ = Σ (g_ī − g_ī there) / Σ w_i.
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
               const FeedPopulations<Real>& feeds, Populations<Real>& populations,
               std::vector<PortFlow>& flow) const;

private:
    struct Link {
        std::uint32_t even_source, even_target, odd_source, odd_target;
        int i, j, direction;
        Real weight;
    };
    struct Port {
        std::vector<Link> links;
        bool across_x = false;  ///< it faces along x
        double weight = 0.0;    ///< Σ w
    };
    /// Of a port that is fed.
    static void feed(const Port& port, const FedInflow& from, const Populations<Real>& there,
                     Populations<Real>& here, PortFlow& flow);
    std::vector<Port> ports_;
};

}  // namespace tt
