#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/choice.hpp"
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

/// A table of the case file.
template <class T>
concept TomlTable = Fielded<T>;

/// Tables that the user names, [port.NAME]: a list of structs whose `name` is no field.
template <class T>
inline constexpr bool is_named_tables = false;
template <TomlTable S>
inline constexpr bool is_named_tables<std::vector<S>> = requires(S s) {
    s.name;
    requires !requires { S::listed; };
};

/// Tables that come as often as the user likes, [[kind]]: their struct says so. One with a `name`
/// is named by it.
template <class T>
inline constexpr bool is_listed_tables = false;
template <TomlTable S>
inline constexpr bool is_listed_tables<std::vector<S>> = requires {
    S::listed;
};

template <class T>
inline constexpr bool is_tables = is_named_tables<T> || is_listed_tables<T>;

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

/// Of a FieldEntry: the type of its member.
template <class F>
struct ValueType;
template <class S, class T>
struct ValueType<FieldEntry<S, T>> {
    using type = T;
};
template <class F>
using value_type_of = typename ValueType<std::remove_cvref_t<F>>::type;

/// The words a field may have: of its type if that is a choice, else those listed with it.
template <class F, class T>
std::string_view words_of_field(const F& field, const T&) {
    if constexpr (Choosable<item_type<T>>)
        return all_words<item_type<T>>();
    else
        return field.choices;
}

/// The fields of a struct: its own, and after each choice those of its alternatives, a key that
/// several have once.
template <class S, class F>
void for_each_key(F&& f) {
    for_each_field<S>([&](const auto& field) {
        using T = item_type<std::remove_cvref_t<decltype(std::declval<S>().*field.member)>>;
        f(field);
        if constexpr (has_keys<T>) {
            for_each_alternative<T>([&]<class A>() {
                if constexpr (Fielded<A>)
                    for_each_field<A>([&](const auto& own) {
                        if (words_with_key<T>(own.key).front() == A::name) f(own);
                    });
            });
        }
    });
}

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
