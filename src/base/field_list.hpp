#pragma once

#include <limits>
#include <string_view>
#include <tuple>

namespace tt {

/// Admissible values of a number, in SI. Open ends exclude the bound itself.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;

    constexpr bool contains(double v) const {
        return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high);
    }
};
inline constexpr Range any_value{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{0.0, std::numeric_limits<double>::infinity(), false, false};

/// One field of a struct: its key in files, its member, its meaning in one line, its admissible
/// values. `choices` lists the words of a string field, separated by '|'. The dimension of a
/// Quantity member is in its type; `example` is a value as the user would write it ("80 um"), whose
/// unit is the customary one of this field.
template <class S, class T>
struct FieldEntry {
    std::string_view key;
    T S::*member;
    std::string_view meaning;
    Range range = any_value;
    std::string_view choices = {};
    std::string_view example = {};
};
template <class S, class T>
FieldEntry(std::string_view, T S::*, std::string_view) -> FieldEntry<S, T>;
template <class S, class T>
FieldEntry(std::string_view, T S::*, std::string_view, Range) -> FieldEntry<S, T>;
template <class S, class T>
FieldEntry(std::string_view, T S::*, std::string_view, Range, std::string_view) -> FieldEntry<S, T>;
template <class S, class T>
FieldEntry(std::string_view, T S::*, std::string_view, Range, std::string_view, std::string_view)
    -> FieldEntry<S, T>;

/// Specialise with `static constexpr auto entries = std::tuple{FieldEntry{…}, …};`. The one list
/// from which reading, range faults, units, reference pages, echoes and table headers are made.
template <class S>
struct FieldList;

template <class S, class F>
constexpr void for_each_field(F&& f) {
    std::apply([&](const auto&... entry) { (f(entry), ...); }, FieldList<S>::entries);
}

}  // namespace tt
