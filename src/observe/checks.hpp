#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/csv.hpp"
#include "io/json.hpp"
#include "observe/windows.hpp"

namespace tt {

/// One judgement of a run from its results. Told in the same words by `run`, by `status`, in
/// summary.json and on the report page.
struct RunCheck {
    enum class Verdict : std::uint8_t { ok, warning, failed };
    std::string name;
    Verdict verdict = Verdict::ok;
    double value = 0.0;  ///< NaN where there was nothing to measure
    double limit = 0.0;  ///< beyond it a warning
    std::string unit;
    std::string sentence;  ///< what was found and, where that is not in order, what it means
};

/// Beyond these a warning, with the reasons in docs/decisions/0011-checks.md.
inline constexpr double largest_area_error = 1e-3;
inline constexpr double largest_mach = 0.15;
inline constexpr double largest_turn_deg = 60.0;
inline constexpr double smallest_radius_sites = 1.0;
inline constexpr double correlation_times_in_window = 10.0;

/// What the tables do not say of themselves.
struct CheckInput {
    Length dx;             ///< site spacing; 0: not known
    bool finished = true;  ///< else nothing is said of the averaging window
    Window window;
    bool channel = false;  ///< walls at rest, between which something drives the flow
    Rate held_rate;        ///< pseudo-shear rate that a controller holds; 0: none
};

/// All checks that apply to a run with these rows of series.csv: overlap, gap, repulsion, area,
/// resolution (with cells), mach, and of a finished run speed, window, standard_error. The worst
/// row counts.
std::vector<RunCheck> judge(const Table& series, const CheckInput& input);

/// Those of a results directory: what its summary.json says, else what its rows so far say, and
/// `stability` of a run that blew up; none where there are no rows yet. Throws IoError if a file is
/// damaged.
std::vector<RunCheck> read_checks(const std::filesystem::path& results);

/// `{name, verdict, value, limit, unit, sentence}`, verdict ok | warning | failed.
Json to_json(const std::vector<RunCheck>& checks);

/// The reverse; what it does not know is left out.
std::vector<RunCheck> checks_from(const Json& list);

/// For the terminal: "warning: …" or "FAILED: …" a check that is not in order, within 79 columns,
/// the resolution last; one line that all is in order where it is. Empty without checks.
std::string describe_checks(const std::vector<RunCheck>& checks);

}  // namespace tt
