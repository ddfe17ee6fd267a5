#include "case/cures.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/units.hpp"
#include "case/choose.hpp"
#include "case/discretise.hpp"
#include "case/kinds.hpp"

namespace tt {
namespace {

/// A case being changed, with the words for it.
struct Change {
    Case c;
    std::string settings;

    void add(std::string_view key, const std::string& value) {
        settings += fmt::format("{}--set {}={}", settings.empty() ? "" : " ", key, value);
    }
    void drop_jump_correction() {
        c.numerics.jump_correction = false;
        add("numerics.jump_correction", "false");
    }
    void hold_area() {
        if (c.kinds.empty()) {
            c.membrane.hold_area = true;
            add("membrane.hold_area", "true");
        }
        for (KindCase& kind : c.kinds) {
            if (kind.hold_area) continue;
            kind.hold_area = true;
            add(fmt::format("kind.{}.hold_area", kind.name), "true");
        }
    }
    /// At the same relaxation time, so that a state can be taken over.
    void shorten_step(double factor, const Choice& choice) {
        const bool implied = c.numerics.dt && c.numerics.density_scale;
        const std::string text = rounded_text(Time{choice.dt.si * factor}, 3);
        c.numerics.dt = Time{parse_measure(text).si};
        add("numerics.dt", fmt::format("\"{}\"", text));
        if (!c.numerics.density_scale) return;
        c.numerics.density_scale.reset();
        add("numerics.density_scale", "auto");
        if (!implied) return;  // it does not depend on them
        c.numerics.relaxation_time = choice.relaxation_time;
        add("numerics.relaxation_time", to_text(choice.relaxation_time));
    }
};

}  // namespace

std::vector<Remedy> cures(const Case& c, int threads) {
    const Choice choice = choose(c);
    std::vector<Remedy> remedies;
    const auto offer = [&](const std::function<void(Change&)>& make) {
        Change change{c, {}};
        make(change);
        try {
            Model model = discretise(change.c);
            model.threads = threads;
            remedies.push_back({change.settings, std::move(model)});
        } catch (const CaseError&) {  // contradicts what the case fixes: no remedy
        }
    };
    const bool cells = !c.numerics.fluid_only;
    const bool correction = cells && choice.jump_correction && viscosity_contrast(c) > 1.0;
    const bool far = correction && viscosity_contrast(c) > 10.0;
    const std::vector<Case> kinds = cases_by_kind(c);
    const bool free = cells && std::any_of(kinds.begin(), kinds.end(),
                                           [](const Case& one) { return !one.membrane.hold_area; });
    const auto shortened = [&](double factor) {
        return [&choice, factor](Change& change) { change.shorten_step(factor, choice); };
    };
    const auto uncorrected = [](Change& change) { change.drop_jump_correction(); };
    const auto held = [](Change& change) { change.hold_area(); };
    // All that applies, and a shorter step too.
    const auto cautious = [&](double factor) {
        return [&, factor](Change& change) {
            if (correction) change.drop_jump_correction();
            if (free) change.hold_area();
            if (factor < 1.0) change.shorten_step(factor, choice);
        };
    };
    if (far) offer(uncorrected);
    if (free) offer(held);
    if (far && free) offer(cautious(1.0));
    for (const double factor : {0.5, 0.25, 0.125}) offer(shortened(factor));
    if (correction && !far) offer(uncorrected);
    if (correction || free)
        for (const double factor : {0.25, 0.0625}) offer(cautious(factor));
    return remedies;
}

}  // namespace tt
