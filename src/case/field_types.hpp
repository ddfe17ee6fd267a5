#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/field_list.hpp"
#include "base/quantity.hpp"
#include "base/units.hpp"

namespace tt {

// What the walkers over field lists need to know of a member's type.

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

template <class T>
inline constexpr bool is_quantity = false;
template <Dimension D>
inline constexpr bool is_quantity<Quantity<D>> = true;

/// A struct with a field list of its own: a table of the case file.
template <class T>
concept TomlTable = requires {
    FieldList<T>::entries;
};

/// The type of the single values in a field: of an optional or a list, that of its items.
template <class T>
struct ItemType {
    using type = T;
};
template <class T>
struct ItemType<std::optional<T>> : ItemType<T> {};
template <class T>
struct ItemType<std::vector<T>> : ItemType<T> {};
template <class T>
using item_type = typename ItemType<T>::type;

/// "um" of the example "80 um" or ["80 um", "20 um"]; empty for plain numbers and words.
inline std::string_view unit_of(std::string_view example) {
    const std::size_t number = example.find_first_of("0123456789");
    if (number == std::string_view::npos) return {};
    example.remove_prefix(number);
    example.remove_prefix(number_length(example));
    example = example.substr(0, example.find('"'));
    if (example.empty() || example.front() != ' ') return {};
    return example.substr(1);
}

}  // namespace tt
