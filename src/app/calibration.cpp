#include "app/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "io/toml.hpp"
#include "report/gnuplot.hpp"

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

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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
        line_of("D", best_D(c)) + line_of("beta", best_beta(c)) +
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
    for (const TriedPair& pair : c.pairs)
        if (pair.found.empty())
            text += wrapped(fmt::format("failed: D = {}, beta = {}: {}", to_text(pair.D),
                                        to_text(pair.beta), pair.failure),
                            79, 8) +
                    "\n";
    if (!now.settled)
        text +=
            wrapped(fmt::format("\nNot settled after {} pairs: the minimum lies {:.2g} standard "
                                "uncertainties from the nearest pair tried. Raise most_pairs "
                                "and say the same command again.",
                                c.pairs.size(), now.way),
                    79) +
            "\n";
    text +=
        fmt::format("\n[membrane.hardening]\nform = {}\nD    = {}\nbeta = {}\n",
                    toml_string(hardening_of(c).form), to_text(c.best().D), to_text(c.best().beta));
    return text;
}

Json to_json(const Calibration& c) {
    const Standpoint& now = c.search.standpoint();
    const std::vector<Goal> goals = c.goals();
    Json j;
    j["name"] = c.targets.name;
    j["program"] = fmt::format("tanktread {}", version);
    j["form"] = hardening_of(c).form;
    j["D"] = to_json(best_D(c));
    j["beta"] = to_json(best_beta(c));
    j["correlation_of_logarithms"] = now.estimate.correlation;
    j["chi_squared"] = misfit(c.best().found, goals);
    j["settled"] = now.settled;
    j["seeds"] = c.targets.seeds;
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

void draw_valley(const Calibration& c, const std::filesystem::path& out) {
    constexpr int steps = 100;
    const Standpoint& now = c.search.standpoint();
    std::string map = "# D, beta, chi2 - least, from the surfaces\n";
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            const Vec2 p{static_cast<double>(i) / steps, static_cast<double>(j) / steps};
            map += fmt::format("{:.6g} {:.6g} {:.6g}\n", c.targets.D.value(p.x),
                               c.targets.beta.value(p.y),
                               c.search.landscape().misfit(p) - now.estimate.misfit);
        }
        map += '\n';
    }
    std::string lines = "# the best beta for each D\n";
    for (const ValleyPoint& p : valley_of(c, 101))
        lines += p.at_end ? "\n" : fmt::format("{:.6g} {:.6g}\n", p.D, p.beta);
    std::string tried, failed;
    for (const TriedPair& pair : c.pairs)
        (pair.found.empty() ? failed : tried) += fmt::format("{} {}\n", pair.D, pair.beta);
    lines += "\n\n# pairs tried\n" + tried + "\n\n# the best of them\n" +
             fmt::format("{} {}\n", c.best().D, c.best().beta);
    if (!failed.empty()) lines += "\n\n# pairs that failed\n" + failed;
    write_style(out);
    write_text(out / "valley-map.dat", map);
    write_text(out / "valley.dat", lines);
    std::string body = fmt::format(
        R"(unset logscale
set xrange [*:*]
set yrange [*:*]
set table "valley-contours.dat"
set contour base
unset surface
set cntrparam levels discrete 1, 4, 25
splot "valley-map.dat" using (log10($1)):(log10($2)):3
unset table
set surface
unset contour
set logscale xy
set xrange [{}:{}]
set yrange [{}:{}]
set xlabel "{{/:Italic D}}"
set ylabel "{{/:Italic β}}"
set key bottom left box opaque
level(z, wanted, value) = abs(z - wanted) < 0.1 ? 10**value : NaN
plot "valley-contours.dat" using (10**$1):(level($3, 1, $2)) with lines lt 1 lw 2 title "χ^2 = least + 1", \
     "" using (10**$1):(level($3, 4, $2)) with lines lt 6 title "least + 4", \
     "" using (10**$1):(level($3, 25, $2)) with lines lc rgb "#bbbbbb" title "least + 25", \
     "valley.dat" index 0 with lines lt 2 title "best {{/:Italic β}} for each {{/:Italic D}}", \
     "" index 1 with points lc rgb "#555555" pt 7 ps 0.4 title "tried", \
     "" index 2 with points lt 2 pt 3 ps 1.2 title "best")",
        c.targets.D.low, c.targets.D.high, c.targets.beta.low, c.targets.beta.high);
    if (!failed.empty())
        body +=
            ", \\\n     \"\" index 3 with points lc rgb \"#555555\" pt 2 ps 0.8 title \"failed\"";
    run_gnuplot(out, "valley", body, 340, 300);
}

}  // namespace tt
