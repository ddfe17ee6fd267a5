#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "base/field_list.hpp"

namespace tt {

// A choice of the case file is a type: either an enumeration whose words are listed with it,
//
//     enum class Sides { walls, periodic };
//     template <> inline constexpr auto words_of<Sides> = std::to_array<std::string_view>({"walls",
//     "periodic"});
//
// or a std::variant of structs, each with its word as `name`, and with a field list of its own
// (base/field_list.hpp) where it has keys that mean nothing without it. Reading, faults, the
// reference of keys and the echo follow from the type.

/// The words of an enumeration, in the order of its values 0, 1, …
template <class E>
inline constexpr auto words_of = nullptr;

template <class T>
concept WordChoice = std::is_enum_v<T> &&
    !std::is_same_v<std::remove_cvref_t<decltype(words_of<T>)>, std::nullptr_t>;

template <class T>
inline constexpr bool is_variant = false;
template <class... Alternatives>
inline constexpr bool is_variant<std::variant<Alternatives...>> = true;

template <class T>
concept StructChoice = is_variant<T>;

template <class T>
concept Choosable = WordChoice<T> || StructChoice<T>;

/// Calls f<Alternative>() for each alternative of a variant, in order.
template <class Variant, class F>
constexpr void for_each_alternative(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (f.template operator()<std::variant_alternative_t<I, Variant>>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>());
}

/// The word that stands for the value.
template <WordChoice E>
constexpr std::string_view word_of(E value) {
    return words_of<E>[static_cast<std::size_t>(value)];
}
template <StructChoice V>
constexpr std::string_view word_of(const V& choice) {
    return std::visit([](const auto& chosen) { return std::string_view(chosen.name); }, choice);
}

/// Chooses by word, a struct as it is by default. False, without a change, if there is no such
/// word.
template <WordChoice E>
bool choose_word(std::string_view word, E& choice) {
    const auto found = std::find(words_of<E>.begin(), words_of<E>.end(), word);
    if (found == words_of<E>.end()) return false;
    choice = static_cast<E>(found - words_of<E>.begin());
    return true;
}
template <StructChoice V>
bool choose_word(std::string_view word, V& choice) {
    bool found = false;
    for_each_alternative<V>([&]<class A>() {
        if (A::name != word) return;
        choice = A{};
        found = true;
    });
    return found;
}

/// All words, separated by '|'.
template <Choosable T>
const std::string& all_words() {
    static const std::string words = [] {
        std::string text;
        const auto add = [&](std::string_view word) {
            text.append(text.empty() ? "" : "|").append(word);
        };
        if constexpr (WordChoice<T>)
            for (const std::string_view word : words_of<T>) add(word);
        else
            for_each_alternative<T>([&]<class A>() { add(A::name); });
        return text;
    }();
    return words;
}

/// A struct with a field list: a table of the case file, or a choice with keys of its own.
template <class T>
concept Fielded = requires {
    FieldList<T>::entries;
};

/// Whether any alternative has keys of its own.
template <class T>
inline constexpr bool has_keys = false;
template <class... Alternatives>
inline constexpr bool has_keys<std::variant<Alternatives...>> = (Fielded<Alternatives> || ...);

/// The words of the alternatives that have this key.
template <StructChoice V>
std::vector<std::string_view> words_with_key(std::string_view key) {
    std::vector<std::string_view> words;
    for_each_alternative<V>([&]<class A>() {
        if constexpr (Fielded<A>)
            for_each_field<A>([&](const auto& field) {
                if (field.key == key) words.push_back(A::name);
            });
    });
    return words;
}

}  // namespace tt
