#pragma once

#include <cstdint>
#include <string_view>

#include "base/quantity.hpp"

namespace tt {

/// Factor to SI, exact: numerator / denominator · 10^exponent, times `irrational` for degrees only.
struct Unit {
    Dimension dimension;
    int exponent = 0;
    std::uint64_t numerator = 1;
    std::uint64_t denominator = 1;
    double irrational = 1.0;
};

/// Reads "um", "/s", "dyn/cm", "kg/(m s)", "mPa.s", "s-1": products, quotients and whole powers of
/// the symbols that stand here in unit.cpp. Throws UnitError.
Unit parse_unit(std::string_view text);

}  // namespace tt
