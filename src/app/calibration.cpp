#include "app/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "io/toml.hpp"

namespace tt {
namespace {

struct Uncertain {
    double value = 0.0, deviation = 0.0, low = 0.0, high = 0.0;
    bool at_end = false;  ///< the region with χ² ≤ least + 1 reaches the end of the range
};

Uncertain uncertain(const LogRange& range, double value, double deviation, double low,
                    double high) {
    constexpr double end = 0.005;
    return {value, value * deviation * range.width(), range.value(low), range.value(high),
            low < end || high > 1.0 - end};
}
Uncertain best_D(const Calibration& c) {
    const Estimate& e = c.search.standpoint().estimate;
    return uncertain(c.targets.D, c.best().D, e.deviation.x, e.low.x, e.high.x);
}
Uncertain best_beta(const Calibration& c) {
    const Estimate& e = c.search.standpoint().estimate;
    return uncertain(c.targets.beta, c.best().beta, e.deviation.y, e.low.y, e.high.y);
}

std::string line_of(const char* name, const Uncertain& u) {
    return fmt::format("{:<5} {:<7.4g} +- {:<7.2g} from {:.3g} to {:.3g} at chi2 <= least + 1{}\n",
                       name, u.value, u.deviation, u.low, u.high,
                       u.at_end ? ", the end of its range" : "");
}

const HardeningCase& hardening_of(const Calibration& c) {
    return c.targets.conditions.front().c.membrane.hardening;
}

std::string described_targets(const Calibration& c) {
    std::string text = fmt::format("{:<20} {:>9} {:>9} {:>9} {:>6} {:>9}  {}\n", "quantity",
                                   "wanted", "+-", "found", "off", "surface", "where");
    const std::vector<Goal> goals = c.goals();
    for (std::size_t k = 0; k < goals.size(); ++k) {
        const Target& target = c.targets.targets[k];
        const double found = c.best().found[k];
        text += fmt::format("{:<20} {:>9.5g} {:>9.2g} {:>9.5g} {:>+6.1f} {:>9.1g}  {}\n",
                            target.quantity, target.goal.value, target.goal.uncertainty, found,
                            (found - target.goal.value) / target.goal.uncertainty,
                            c.search.landscape().error(k),
                            c.targets.conditions[target.condition].label);
    }
    return text;
}

std::string described_failures(const Calibration& c) {
    constexpr std::size_t shown = 3;
    std::vector<const TriedPair*> failed;
    for (const TriedPair& pair : c.pairs)
        if (pair.found.empty()) failed.push_back(&pair);
    std::string text = failed.empty() ? "" : "\n";
    for (std::size_t k = 0; k < std::min(failed.size(), shown); ++k)
        text += wrapped(fmt::format("failed: D = {}, beta = {}: {}", to_text(failed[k]->D),
                                    to_text(failed[k]->beta), failed[k]->failure),
                        79, 8) +
                "\n";
    if (failed.size() > shown)
        text += fmt::format("and {} more; calibration.json has them all\n", failed.size() - shown);
    if (2 * failed.size() > c.pairs.size())
        text += "Most pairs failed: take a smaller numerics.dt or lower ends of the ranges.\n";
    return text;
}

std::string described_ending(const Calibration& c) {
    const Standpoint& now = c.search.standpoint();
    if (now.settled) return {};
    return wrapped(
               fmt::format("NOT SETTLED after {} pairs: the minimum of the surfaces lies {:.2g} "
                           "standard uncertainties from the nearest pair tried. What follows is "
                           "the best pair tried, with the uncertainties of that minimum. Raise "
                           "most_pairs and give the same command again.",
                           c.pairs.size(), now.way),
               79) +
           "\n\n";
}

/// The pair that the case has, if it was tried.
const TriedPair* own_pair(const Calibration& c) {
    for (const TriedPair& pair : c.pairs)
        if (pair.D == hardening_of(c).D && pair.beta == hardening_of(c).beta && !pair.found.empty())
            return &pair;
    return nullptr;
}

double way_to(const Calibration& c, const TriedPair& pair) {
    const Estimate& e = c.search.standpoint().estimate;
    return e.way(e.best, c.place(pair.D, pair.beta));
}

Json to_json(const Uncertain& u) {
    return {{"value", u.value},
            {"standard_uncertainty", u.deviation},
            {"low", u.low},
            {"high", u.high},
            {"open", u.at_end}};
}

Json to_json(const TriedPair& pair, const std::vector<Goal>& goals) {
    Json j{{"D", pair.D}, {"beta", pair.beta}};
    if (pair.found.empty()) {
        j["failed"] = pair.failure;
        return j;
    }
    j["chi_squared"] = misfit(pair.found, goals);
    j["found"] = pair.found;
    j["scatter"] = Json::array();
    for (const double scatter : pair.scatter) j["scatter"].push_back(number(scatter));
    return j;
}

}  // namespace

std::vector<Goal> Calibration::goals() const {
    std::vector<Goal> result;
    for (const Target& target : targets.targets) result.push_back(target.goal);
    return result;
}

std::vector<ValleyPoint> valley_of(const Calibration& c, int points) {
    std::vector<ValleyPoint> valley;
    for (int k = 0; k < points; ++k) {
        const Vec2 p = best_at(c.search.landscape(), static_cast<double>(k) / (points - 1));
        valley.push_back({c.targets.D.value(p.x), c.targets.beta.value(p.y),
                          c.search.landscape().misfit(p), p.y <= 0.0 || p.y >= 1.0});
    }
    return valley;
}

std::string describe(const Calibration& c) {
    const Standpoint& now = c.search.standpoint();
    const std::vector<Goal> goals = c.goals();
    const auto failed = std::count_if(c.pairs.begin(), c.pairs.end(),
                                      [](const TriedPair& p) { return p.found.empty(); });
    std::string text =
        fmt::format("{}: {} pairs tried, {} of them failed\n\n", c.targets.name, c.pairs.size(),
                    failed) +
        described_ending(c) + line_of("D", best_D(c)) + line_of("beta", best_beta(c)) +
        fmt::format("correlation {:.3f}; chi2 {:.3g} of {} number{}, two of them free\n\n",
                    now.estimate.correlation, misfit(c.best().found, goals), goals.size(),
                    goals.size() == 1 ? "" : "s") +
        described_targets(c);
    text += "\nvalley: the best beta for each D\n        D      beta      chi2\n";
    for (const ValleyPoint& p : valley_of(c, 11))
        text += fmt::format("{:>9.4g} {:>9.4g} {:>9.3g}{}\n", p.D, p.beta, p.chi_squared,
                            p.at_end ? "  beta at the end of its range" : "");
    if (const TriedPair* own = own_pair(c))
        text += fmt::format(
            "\nThe pair of the case, D = {}, beta = {}: chi2 {:.3g}, {:.1f} standard "
            "uncertainties away\n",
            to_text(own->D), to_text(own->beta), misfit(own->found, goals), way_to(c, *own));
    text += described_failures(c);
    text += fmt::format("\n[membrane.hardening]\nform = {}\nD    = {}\nbeta = {}\n",
                        toml_string(word_of(hardening_of(c).form)), to_text(c.best().D),
                        to_text(c.best().beta));
    return text;
}

Json to_json(const Calibration& c) {
    const Standpoint& now = c.search.standpoint();
    const std::vector<Goal> goals = c.goals();
    Json j;
    j["name"] = c.targets.name;
    j["program"] = "tanktread " + version_text();
    j["form"] = hardening_of(c).form;
    j["D"] = to_json(best_D(c));
    j["beta"] = to_json(best_beta(c));
    j["correlation_of_logarithms"] = now.estimate.correlation;
    j["chi_squared"] = misfit(c.best().found, goals);
    j["settled"] = now.settled;
    j["seeds"] = c.targets.seeds;
    j["inputs"] = to_json(c.targets.inputs);
    for (std::size_t k = 0; k < goals.size(); ++k) {
        const Target& target = c.targets.targets[k];
        j["targets"].push_back({{"quantity", target.quantity},
                                {"unit", target.unit},
                                {"set", c.targets.conditions[target.condition].label},
                                {"value", target.goal.value},
                                {"uncertainty", target.goal.uncertainty},
                                {"found", c.best().found[k]},
                                {"scatter", number(c.best().scatter[k])},
                                {"surface_order", c.search.landscape().order(k)},
                                {"surface_error", number(c.search.landscape().error(k))}});
    }
    for (const ValleyPoint& p : valley_of(c, 21))
        j["valley"].push_back({{"D", p.D},
                               {"beta", p.beta},
                               {"chi_squared", p.chi_squared},
                               {"beta_at_end", p.at_end}});
    if (const TriedPair* own = own_pair(c)) {
        j["pair_of_the_case"] = to_json(*own, goals);
        j["pair_of_the_case"]["standard_uncertainties_away"] = number(way_to(c, *own));
    }
    for (const TriedPair& pair : c.pairs) j["pairs"].push_back(to_json(pair, goals));
    return j;
}

}  // namespace tt
