#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/toml.hpp"

namespace tt {

/// A value that a swept key takes.
struct SweepValue {
    std::string text;     ///< as people write it: 0.2, 20 um, shear, area
    std::string setting;  ///< as it stands after --set KEY=
    Fault place;          ///< where it was written, the message empty
};

/// A key of the case file and its values.
struct SweptKey {
    std::string key;  ///< "flow.shear_number"
    std::vector<SweepValue> values;
};

/// One dimension of a sweep: keys that change together, each with as many values.
struct SweepAxis {
    std::vector<SweptKey> keys;

    std::size_t size() const { return keys.empty() ? 0 : keys.front().values.size(); }
};

/// Values as text: a list, "0.1, 0.2, 0.5", whose items may be ranges, "0.1:1:0.1" or "0.1:10:*10".
/// A unit behind the last number is that of all: "20, 40 um", "50:500:50 /s". The values of a range
/// have at most twelve digits. Faults are told at `place`.
std::vector<SweepValue> listed_values(std::string_view text, const Fault& place,
                                      std::vector<Fault>& faults);

/// What stands after --over: "KEY=VALUES", or several with ';' between that change together.
SweepAxis axis_of_option(const std::string& text, std::vector<Fault>& faults);

/// A table [[over]] of the file `name`: keys with lists, or with values as text.
SweepAxis axis_of_table(const TomlNode& table, const std::string& name, std::vector<Fault>& faults);

/// The axis as a table [[over]], which reads back to the same.
std::string to_toml(const SweepAxis& axis);

}  // namespace tt
