#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/results.hpp"

namespace tt {

/// What was run, in a few sentences from the settings; only what the settings say.
std::string case_in_words(const Results& run);

/// How far the run came, if it is not finished; empty if it is.
std::string unfinished_note(const Results& run);

/// Where the numerics were changed after a blow-up; empty for a run that is the same all through.
std::string changes_note(const Results& run);

/// What a quantity of the summary means; empty if it is none.
std::string meaning_of_quantity(const std::string& name);

/// A number with its unit as a person of the field writes it: µm, ms, mm/s, mPa s; `digits`
/// significant digits.
struct DisplayUnit {
    double factor;
    std::string name;
};
DisplayUnit display_unit(const std::string& si_unit);
std::string number_text(double value, int digits = 4);

/// Mean ± scatter, both to the decimal of the scatter's second digit, with a common power of ten
/// where numbers are very large or small: "1.1143 ± 0.0074", "(4.00 ± 0.86) × 10⁻⁴". A scatter at
/// the level of rounding counts as none.
std::string with_scatter(double mean, double scatter);

}  // namespace tt
