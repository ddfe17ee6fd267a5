#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "observe/observer.hpp"
#include "observe/run_request.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// All who watch a run, as one.
class Observers {
public:
    void add(std::unique_ptr<Observer> observer) { all_.push_back(std::move(observer)); }
    auto begin() const { return all_.begin(); }
    auto end() const { return all_.end(); }

    void start() const;
    /// The first step after `step` at which any look is due.
    std::int64_t next_after(std::int64_t step) const;
    void observe_due(const Model& model, const State& state) const;
    /// Those to whom this step is not due: the last look at the end of a run.
    void observe_others(const Model& model, const State& state) const;
    void finish() const;

private:
    std::vector<std::unique_ptr<Observer>> all_;
};

/// Series, profiles and frames in `results`, with rows every `series` and frames every `frames`.
Observers observers_of(const RunRequest& request, const std::filesystem::path& results, Time series,
                       Time frames, const Model& model, const State& state,
                       const std::function<void(const std::string&)>& say);

}  // namespace tt
