#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "base/quantity.hpp"

namespace tt {

/// What the user wrote is not a number with a unit we know. The message says what is wrong and what
/// to write.
class UnitError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A number with its dimension, in SI.
struct Measure {
    double si = 0.0;
    Dimension dimension;
};

/// Reads "80 um", "500 /s", "1.8e-12 dyn cm", "38 %", "1025 kg/m^3". Units are products, quotients
/// and whole powers of the symbols in base/unit.cpp with the prefixes z a f p n u m c d k M G. The
/// conversion is exact in decimal and rounded once, so that "80 um", "0.08 mm" and "8e-5 m" are the
/// same double (test Units.same_length_same_bits). Throws UnitError.
Measure parse_measure(std::string_view text);

/// The length of the number at the start of `text`; 0 if there is none.
std::size_t number_length(std::string_view text);

/// `si` in the unit named: to_text(2e-7, "um") is "0.2 um". Reads back to the same bits; a unit
/// that cannot do that for this number gives way to SI.
std::string to_text(double si, std::string_view unit);

/// `si` in whichever customary unit of its dimension gives a number between 0.1 and 1000.
std::string to_text(double si, Dimension dimension);
template <Dimension D>
std::string to_text(Quantity<D> quantity) {
    return to_text(quantity.si, D);
}

/// The same, rounded to `digits` digits: for messages.
std::string rounded_text(double si, Dimension dimension, int digits = 4);
template <Dimension D>
std::string rounded_text(Quantity<D> quantity, int digits = 4) {
    return rounded_text(quantity.si, D, digits);
}

/// The shortest decimal that reads back to the same double: 0.2, 1500, 1.8e-19.
std::string to_text(double number);

/// "length", "viscosity", …; "kg m^2 s^-1" for one without a name.
std::string dimension_name(Dimension dimension);

/// The SI unit of a dimension as parse_measure reads it: "m", "Pa s", "N/m".
std::string si_unit(Dimension dimension);

}  // namespace tt
