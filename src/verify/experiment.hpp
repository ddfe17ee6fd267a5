#pragma once

#include <cstdint>

#include "case/case.hpp"
#include "exchange/periodic.hpp"
#include "grid/field.hpp"
#include "membrane/suspension.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// A model and its state, advanced as `run` does but without files and observers: what the selftest
/// and the tests of physics look at. Lattice units.
struct Experiment {
    Model model;
    State state;
    Periodic ends;

    /// What `run` would start from this case.
    explicit Experiment(const Case& c);
    /// Cells in a fluid of density 1 and this velocity; the drive's body force acts from the start.
    Experiment(const Model& m, const Suspension& cells, const VectorField<>& velocity);
    Experiment(const Model& m, const Suspension& cells);  ///< the fluid at rest

    /// On `model.threads` threads. Throws SimulationError if it blows up.
    void advance_by(std::int64_t steps);
    /// Until k t, k the model's shear rate.
    void advance_to_strain(double strain);
    /// Steps made.
    double time() const { return static_cast<double>(state.step); }
};

/// The velocity (k (y − H/2), 0) between walls H apart.
VectorField<> simple_shear(const Lattice& lattice, double rate);

/// A model of uniform viscosity without drive, cells' laws or contact: the start of a scene.
/// Lattice units; `scales` is such that SI and lattice values are the same number.
Model plain_model(const Lattice& lattice, double viscosity);

}  // namespace tt
