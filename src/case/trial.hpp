#pragma once

#include <cstdint>
#include <optional>

#include "base/error.hpp"
#include "case/appraise.hpp"

namespace tt {

/// Whether no bound tells beforehand how a run goes: numerics by hand, beyond what is usual, or
/// cells so dense that they start bent by each other.
bool is_unusual(const Case& c, const Choice& choice, const Appraisal& a);

/// What goes wrong in so many steps from a copy of `state`, made and watched as a run makes them.
/// Nothing where all goes well. Throws StoppedEarly where the program is asked to stop.
std::optional<Instability> instability_within(std::int64_t steps, const Model& model,
                                              const State& state);

/// What to say of a case whose run went wrong so: what was seen, and what to write, tried in
/// memory, a minute at most.
Advice refusal_after(const Instability& what, const Case& c, const Model& model,
                     const State& initial);

/// Appraises a start and, where it is unusual, tries it: some hundred steps, the same on any
/// machine, fewer where they are costly. `check`, `run` and `sweep` judge by it.
Appraisal appraise_with_trial(const Case& c, const Choice& choice, const Model& model,
                              const State& initial);

/// Throws CaseError with what that refuses: a run that would end unstable does not start.
void expect_stable(const Case& c, const Choice& choice, const Model& model, const State& initial);

}  // namespace tt
