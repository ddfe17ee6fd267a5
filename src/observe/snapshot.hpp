#pragma once

#include <optional>
#include <vector>

#include "observe/measures.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// A read-only look at one step for observers. Measures are taken when first asked for and shared
/// by all who ask.
class Snapshot {
public:
    Snapshot(const Model& model, const State& state) : model_(model), state_(state) {}

    const Model& model() const { return model_; }
    const State& state() const { return state_; }
    std::int64_t step() const { return state_.step; }
    Time time() const { return Time{static_cast<double>(state_.step) * model_.scales.time}; }

    const std::vector<CellMeasures>& cells() const;
    const RunMeasures& run() const;
    const Profiles& profiles() const;

private:
    const Model& model_;
    const State& state_;
    mutable std::optional<std::vector<CellMeasures>> cells_;
    mutable std::optional<RunMeasures> run_;
    mutable std::optional<Profiles> profiles_;
};

}  // namespace tt
