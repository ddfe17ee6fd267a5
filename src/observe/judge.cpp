#include "observe/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "base/units.hpp"

namespace tt {
namespace {

using Verdict = RunCheck::Verdict;

/// The numbers of a column that are numbers; none where there is no such column.
std::vector<double> known(const Table& series, std::string_view name) {
    std::vector<double> values;
    if (!series.has(name)) return values;
    for (const double v : series.column(name))
        if (std::isfinite(v)) values.push_back(v);
    return values;
}

double largest(std::span<const double> values) {
    return values.empty() ? undefined : *std::max_element(values.begin(), values.end());
}

double smallest(std::span<const double> values) {
    return values.empty() ? undefined : *std::min_element(values.begin(), values.end());
}

template <class Bad>
double percent(std::span<const double> values, Bad bad) {
    const auto count = std::count_if(values.begin(), values.end(), bad);
    return 100.0 * static_cast<double>(count) / static_cast<double>(values.size());
}

/// A share in percent, to two digits: "100 %", not "1e+02 %".
std::string percent_text(double share) {
    return rounded_text(100.0 * share, Dimension{}, 2) + " %";
}

/// At most one of the two.
Verdict verdict_of(bool warning, bool failed) {
    return failed ? Verdict::failed : warning ? Verdict::warning : Verdict::ok;
}

/// Judges the rows, one check after the other. A check whose column is missing is left out: tables
/// of an older version lack some.
class Judge {
public:
    Judge(const Table& series, const CheckInput& input) : series_(series), input_(input) {}

    void overlap() {
        const double worst = largest(known(series_, "overlaps"));
        if (std::isnan(worst)) return;
        add({"overlap", verdict_of(false, worst > 0), worst, 0.0, "",
             worst > 0 ? fmt::format("{:.0f} nodes lay inside another cell at once: the contact "
                                     "forces did not keep the cells apart.",
                                     worst)
                       : "No node lay inside another cell."});
    }

    void gap() {
        if (!series_.has("smallest_gap") || input_.dx.si <= 0.0) return;
        const double dx = input_.dx.si;
        const std::vector<double> gaps = known(series_, "smallest_gap");
        const double worst = smallest(gaps);
        if (gaps.empty()) {
            add({"gap", Verdict::ok, undefined, dx, "m",
                 "No two cells were seen within the reach of contact forces."});
            return;
        }
        std::string sentence = fmt::format(
            "The smallest gap between cells was {:.2g} µm, {:.2g} sites", 1e6 * worst, worst / dx);
        if (worst < dx)
            sentence += fmt::format(
                ", below one site in {:.0f} % of the rows: the grid does not "
                "resolve such a film of plasma",
                percent(gaps, [=](double gap) { return gap < dx; }));
        add({"gap", verdict_of(worst < dx, false), worst, dx, "m", sentence + "."});
    }

    void repulsion() {
        const double count = largest(known(series_, "repulsion_count"));
        if (std::isnan(count)) return;
        add({"repulsion", verdict_of(count > 0, false), count, 0.0, "",
             count > 0 ? fmt::format("The short-range repulsion acted on {:.3g} node-steps: these "
                                     "contacts are not those of the contact model alone.",
                                     count)
                       : "The short-range repulsion never acted."});
    }

    void area() {
        const double worst = largest(known(series_, "area_error_max"));
        if (std::isnan(worst)) return;
        const bool bad = worst > largest_area_error;
        add({"area", verdict_of(bad, worst > 10.0 * largest_area_error), worst, largest_area_error,
             "",
             fmt::format("The area of every cell stayed within {} of its own{}.",
                         percent_text(worst),
                         bad ? ", more than 0.1 %: write hold_area = true or a finer dx" : "")});
    }

    void mach() {
        const double worst = largest(known(series_, "mach"));
        if (std::isnan(worst)) return;
        const bool bad = worst > largest_mach;
        add({"mach", verdict_of(bad, worst > 2.0 * largest_mach), worst, largest_mach, "",
             fmt::format("The largest Mach number was {:.2g}{}.", worst,
                         bad ? fmt::format(", above {}: the lattice fluid is compressed by about "
                                           "{}; write a smaller dt",
                                           largest_mach, percent_text(worst * worst))
                             : "")});
    }

    void resolution() {
        const std::vector<double> turns = known(series_, "turn_max_deg");
        const std::vector<double> radii = known(series_, "curvature_radius_sites");
        if (turns.empty() || radii.size() != turns.size()) return;
        const double turn = largest(turns), radius = smallest(radii);
        const bool bad = turn > largest_turn_deg || radius < smallest_radius_sites;
        const bool lost = turn > 1.5 * largest_turn_deg || radius < 0.5 * smallest_radius_sites;
        // Short enough for one line of a terminal: it is the last of a run.
        add({"resolution", verdict_of(bad, lost), turn, largest_turn_deg, "deg",
             fmt::format("Membranes {} (turn {:.0f}°, radius {:.2g} sites){}.",
                         bad ? "not resolved" : "resolved", turn, radius,
                         bad ? ": refine dx" : "")});
    }

    /// Asked of a controller: that it holds what it holds; of any other channel: that the flow is
    /// steady over the window.
    void speed() {
        if (!input_.channel) return;
        const std::vector<double> speeds = in_window("mean_velocity");
        if (speeds.size() < 2) return;
        const double mean = window_statistics(speeds).mean;
        if (input_.held_rate.si != 0.0) {
            const double rate = window_statistics(in_window("pseudo_shear_rate")).mean;
            const double off = std::abs(rate / input_.held_rate.si - 1.0);
            constexpr double limit = 0.01;
            add({"speed", verdict_of(off > limit, off > 10.0 * limit), off, limit, "",
                 fmt::format("The mean velocity was {:.3g} mm/s, {} from what was to be "
                             "held{}.",
                             1e3 * mean, percent_text(off),
                             off > limit ? ": write a later average_from" : "")});
            return;
        }
        const std::span all(speeds);
        const double early = window_statistics(all.first(all.size() / 2)).mean;
        const double late = window_statistics(all.last(all.size() / 2)).mean;
        const double drift = mean == 0.0 ? 0.0 : std::abs((late - early) / mean);
        constexpr double limit = 0.05;
        add({"speed", verdict_of(drift > limit, drift > 10.0 * limit), drift, limit, "",
             fmt::format("The mean velocity was {:.3g} mm/s and changed by {} from half to "
                         "half of the window{}.",
                         1e3 * mean, percent_text(drift),
                         drift > limit ? ": write a later average_from and end" : "")});
    }

    /// Of what papers quote, the quantity whose window is worst.
    void window() {
        double shortest = std::numeric_limits<double>::infinity();
        const char* slowest = nullptr;
        bool enough = true;  // rows to tell a correlation time of what does scatter
        std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
        for (const char* name : {"strain", "taylor_inertia", "mu_rel", "cfl_envelope"}) {
            const WindowStatistics s = window_statistics(in_window(name));
            if (s.samples > 0) fewest = std::min(fewest, s.samples);
            // What scatters by less than the program is exact, or by rounding alone as the shape of
            // a rigid body, needs no average.
            if (!(s.sd > std::max(0.01 * std::abs(s.mean), 1e-11))) continue;
            enough = enough && s.samples >= samples_for_error;
            if (!enough) continue;
            const double times = static_cast<double>(s.samples) / s.correlation_time;
            if (times < shortest) std::tie(shortest, slowest) = std::pair{times, name};
        }
        if (fewest == std::numeric_limits<std::int64_t>::max()) return;
        if (enough) add_window(shortest, slowest, 1e3 * input_.window.length());
        const bool few = fewest < samples_for_error;
        add({"standard_error", verdict_of(few, false), static_cast<double>(fewest),
             static_cast<double>(samples_for_error), "",
             few ? fmt::format("The standard error is not known: {} rows in the averaging window, "
                               "{} are needed. Write a shorter [output] series.",
                               fewest, samples_for_error)
                 : fmt::format("The standard error is known, from {} rows in the averaging window.",
                               fewest)});
    }

    std::vector<RunCheck> all() && { return std::move(checks_); }

private:
    void add(RunCheck check) { checks_.push_back(std::move(check)); }

    void add_window(double times, const char* slowest, double milliseconds) {
        if (!slowest) {
            add({"window", Verdict::ok, undefined, correlation_times_in_window, "",
                 fmt::format(
                     "Nothing changed by more than 1 % in the averaging window of {:.3g} ms.",
                     milliseconds)});
            return;
        }
        const bool bad = times < correlation_times_in_window;
        add({"window", verdict_of(bad, false), times, correlation_times_in_window, "",
             fmt::format("The averaging window of {:.3g} ms is {:.2g} correlation times of {} "
                         "long{}.",
                         milliseconds, times, slowest,
                         bad ? ", 10 are needed: write a later end" : "")});
    }

    std::vector<double> in_window(std::string_view name) const {
        std::vector<double> values;
        if (!series_.has(name) || !series_.has("time")) return values;
        const std::vector<double>& time = series_.column("time");
        const std::vector<double>& column = series_.column(name);
        for (std::size_t k = 0; k < column.size(); ++k)
            if (input_.window.holds(time[k]) && std::isfinite(column[k]))
                values.push_back(column[k]);
        return values;
    }

    const Table& series_;
    const CheckInput& input_;
    std::vector<RunCheck> checks_;
};

}  // namespace

std::vector<RunCheck> judge(const Table& series, const CheckInput& input) {
    Judge judge(series, input);
    if (!known(series, "lambda_C").empty()) {
        judge.overlap();
        judge.gap();
        judge.repulsion();
        judge.area();
    }
    judge.mach();
    if (input.finished) {
        judge.speed();
        judge.window();
    }
    judge.resolution();
    return std::move(judge).all();
}

}  // namespace tt
