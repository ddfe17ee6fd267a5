#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/field_types.hpp"
#include "io/toml.hpp"

namespace tt {

// A value as it stands in a case file, in the unit of the field's example. Reads back to the same
// bits.

inline std::string value_text(bool value, std::string_view) { return value ? "true" : "false"; }
inline std::string value_text(std::int64_t value, std::string_view) {
    return std::to_string(value);
}
inline std::string value_text(const std::string& value, std::string_view) {
    return toml_string(value);
}
inline std::string value_text(double value, std::string_view example) {
    const std::string_view unit = unit_of(example);
    return unit.empty() ? to_text(value) : toml_string(to_text(value, unit));
}
template <Dimension D>
std::string value_text(Quantity<D> value, std::string_view example) {
    if (std::isinf(value.si)) return toml_string("never");
    return toml_string(to_text(value.si, unit_of(example)));
}
template <Choosable T>
std::string value_text(const T& choice, std::string_view) {
    return toml_string(word_of(choice));
}
template <class T>
std::string value_text(const std::optional<T>& value, std::string_view example) {
    return value ? value_text(*value, example) : std::string{};
}
template <class T>
std::string value_text(const std::vector<T>& values, std::string_view example) {
    std::string text = "[";
    for (const T& value : values) {
        if (text.size() > 1) text += ", ";
        text += value_text(value, example);
    }
    return text + "]";
}

}  // namespace tt
