#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

#include "base/letter.hpp"
#include "base/words.hpp"
#include "case/field_types.hpp"
#include "case/unknown_key.hpp"
#include "case/validate.hpp"
#include "case/value_reader.hpp"

namespace tt {

/// Listed tables of which each begins as a copy of something in S, which is read before.
template <class S, class T>
inline constexpr bool starts_as_copies = false;
template <class S, class Item>
inline constexpr bool starts_as_copies<S, std::vector<Item>> = requires(const S& s) {
    Item::like(s);
};

/// Walks the tree along the field lists. Goes on after a fault; what could not be read keeps its
/// default.
template <TomlTable Root>
class Reader : public ValueReader {
public:
    using ValueReader::ValueReader;

    template <TomlTable S>
    void read_table(const TomlNode& table, const TomlEntry* header, const std::string& path,
                    S& result) {
        // Choices first: what else may be written follows from them.
        for_each_field<S>([&](const auto& field) {
            auto& value = result.*field.member;
            if constexpr (StructChoice<std::remove_cvref_t<decltype(value)>>)
                if (const TomlEntry* entry = table.find(field.key))
                    read_field(*entry, join(path, field.key), field, value);
        });
        for (const TomlEntry& entry : table.entries) {
            bool known = false;
            for_each_field<S>([&](const auto& field) {
                auto& value = result.*field.member;
                constexpr bool choice = StructChoice<std::remove_cvref_t<decltype(value)>>;
                if (field.key == entry.key) {
                    known = true;
                    if constexpr (!choice &&
                                  !starts_as_copies<S, std::remove_cvref_t<decltype(value)>>)
                        read_field(entry, join(path, field.key), field, value);
                } else if constexpr (has_keys<std::remove_cvref_t<decltype(value)>>) {
                    known = known || read_key_of_choice(entry, table.find(field.key), path,
                                                        field.key, value);
                }
            });
            if (!known) tell_unknown_key<S>(entry, path);
        }
        for_each_field<S>([&](const auto& field) {
            auto& value = result.*field.member;
            const TomlEntry* entry = table.find(field.key);
            if constexpr (starts_as_copies<S, std::remove_cvref_t<decltype(value)>>)
                if (entry) read_listed_tables(*entry, join(path, field.key), result, value);
            if (entry == nullptr) read_absent(header, join(path, field.key), field, value);
            if constexpr (has_keys<std::remove_cvref_t<decltype(value)>>)
                read_absent_of_choice(table, entry ? entry : header, path, field.key, value);
        });
    }

    Places places;

private:
    std::set<std::string> faulty_;  ///< keys of which the value could not be read

    using ValueReader::read_value;

    static std::string join(const std::string& path, std::string_view key) {
        return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
    }

    template <class F>
    static FieldText text_of(const F& field) {
        return {field.key, field.range, words_of_field(field, value_type_of<F>{}), field.example};
    }

    /// A key that belongs to the alternatives of a choice. Of the one that is chosen it is read; of
    /// another it means nothing, which is told unless the choice is another on the command line
    /// than in the file. False if it is none.
    template <StructChoice V>
    bool read_key_of_choice(const TomlEntry& entry, const TomlEntry* chosen_at,
                            const std::string& path, std::string_view choice_key, V& choice) {
        const auto words = words_with_key<V>(entry.key);
        if (words.empty() || faulty_.contains(join(path, choice_key))) return !words.empty();
        const std::string_view word = word_of(choice);
        if (std::find(words.begin(), words.end(), word) == words.end()) {
            const bool overruled =
                entry.origin.empty() && chosen_at != nullptr && !chosen_at->origin.empty();
            const bool given =
                entry.value.kind != TomlNode::Kind::string || entry.value.text != "auto";
            places[join(path, entry.key)] = place(entry, entry.line, entry.column);
            if (given && !overruled)
                tell_key(entry, fmt::format("{} means nothing with {} = \"{}\"; leave it out",
                                            entry.key, choice_key, word));
            return true;
        }
        std::visit(
            [&](auto& chosen) {
                using A = std::remove_cvref_t<decltype(chosen)>;
                if constexpr (Fielded<A>)
                    for_each_field<A>([&](const auto& field) {
                        if (field.key == entry.key)
                            read_field(entry, join(path, field.key), field, chosen.*field.member);
                    });
            },
            choice);
        return true;
    }

    /// Keys that the chosen alternative needs: those whose default lies outside their range.
    template <StructChoice V>
    void read_absent_of_choice(const TomlNode& table, const TomlEntry* at, const std::string& path,
                               std::string_view choice_key, V& choice) {
        if (faulty_.contains(join(path, choice_key))) return;
        std::visit(
            [&](auto& chosen) {
                using A = std::remove_cvref_t<decltype(chosen)>;
                if constexpr (Fielded<A>)
                    for_each_field<A>([&](const auto& field) {
                        if (table.find(field.key) != nullptr ||
                            !must_be_given(field, chosen.*field.member))
                            return;
                        const bool number = std::is_same_v<value_type_of<decltype(field)>, double>;
                        fault_at(at).message = fmt::format(
                            "{} = \"{}\" needs {} = {}", choice_key, word_of(choice), field.key,
                            number ? std::string(field.example) : toml_string(field.example));
                    });
            },
            choice);
    }

    template <class F, class T>
    static bool must_be_given(const F& field, const T& value) {
        if constexpr (is_quantity<T>) return !field.range.contains(value.si);
        if constexpr (std::is_same_v<T, double>) return !field.range.contains(value);
        if constexpr (std::is_same_v<T, std::string>) return value.empty();
        return false;
    }

    /// A new fault, with the place of a header or of a choice.
    Fault& fault_at(const TomlEntry* at) {
        faults.push_back(at != nullptr ? place(*at, at->line, at->column)
                                       : Fault{file(), 0, 0, {}});
        return faults.back();
    }

    template <class F, class T>
    void read_field(const TomlEntry& entry, const std::string& path, const F& field, T& result) {
        if constexpr (TomlTable<T>) {
            if (entry.value.kind == TomlNode::Kind::table)
                return read_table(entry.value, &entry, path, result);
            const bool twice = entry.value.kind == TomlNode::Kind::array;
            tell_key(entry, fmt::format("{} is a table; write [{}] on a line of its own{}",
                                        field.key, path, twice ? ", once" : ""));
        } else if constexpr (is_named_tables<T>) {
            read_named_tables(entry, path, result);
        } else if constexpr (is_list<T> && TomlTable<item_type<T>>) {
            read_listed_tables(entry, path, result, result);
        } else {
            if constexpr (is_quantity<T>)
                if (entry.value.kind == TomlNode::Kind::string && entry.value.text == "auto" &&
                    field.choices == "auto")
                    return;
            if constexpr (is_optional<T>) {
                const bool word = entry.value.kind == TomlNode::Kind::string;
                if (word && entry.value.text == "auto") return;
                if constexpr (is_quantity<item_type<T>>) {
                    if (word && entry.value.text == "never" && field.choices == "never") {
                        result = item_type<T>{std::numeric_limits<double>::infinity()};
                        return;
                    }
                }
            }
            places[path] = place(entry, entry.line, entry.column);
            const std::size_t before = faults.size();
            read_value(entry, entry.value, text_of(field), result);
            if (faults.size() > before) faulty_.insert(path);
        }
    }

    /// [path.NAME], once for each item.
    template <class T>
    void read_named_tables(const TomlEntry& entry, const std::string& path,
                           std::vector<T>& result) {
        const auto refuse = [&](const TomlEntry& at) {
            tell_key(at, fmt::format("write [{}.NAME] on a line of its own before each", path));
        };
        if (entry.value.kind != TomlNode::Kind::table) return refuse(entry);
        for (const TomlEntry& item : entry.value.entries) {
            if (item.value.kind != TomlNode::Kind::table) {
                refuse(item);
                continue;
            }
            result.emplace_back();
            result.back().name = item.key;
            const std::string name = join(path, item.key);
            places[name] = place(item, item.line, item.column);
            read_table(item.value, &item, name, result.back());
        }
    }

    /// [[path]], once for each item: `name` in it names it.
    template <class S, class T>
    void read_listed_tables(const TomlEntry& entry, const std::string& path, const S& around,
                            std::vector<T>& result) {
        const auto refuse = [&](const TomlEntry& at) {
            tell_key(at, fmt::format("write [[{}]] on a line of its own before each", path));
        };
        if (entry.value.kind != TomlNode::Kind::array) return refuse(entry);
        for (const TomlNode& item : entry.value.items) {
            const TomlEntry header{entry.key, item.line, item.column, {}, entry.origin};
            if (item.kind != TomlNode::Kind::table) {
                refuse(header);
                continue;
            }
            if constexpr (starts_as_copies<S, std::vector<T>>)
                result.push_back(T::like(around));
            else
                result.emplace_back();
            const TomlEntry* name = item.find("name");
            const std::string own =
                join(path, name && !name->value.text.empty() ? name->value.text
                                                             : fmt::format("{}", result.size()));
            places[own] = place(header, header.line, header.column);
            read_table(item, &header, own, result.back());
        }
    }

    template <class F, class T>
    void read_absent(const TomlEntry* header, const std::string& path, const F& field, T& result) {
        if constexpr (TomlTable<T>) {
            read_table(TomlNode{}, header, path, result);
        } else if constexpr (is_quantity<T> || std::is_same_v<T, Measure>) {
            if (!field.range.contains(result.si) && field.choices != "auto")
                tell_missing(header, path, text_of(field));
        }
    }

    void tell_missing(const TomlEntry* header, const std::string& path, const FieldText& field) {
        fault_at(header).message = fmt::format("{} is missing from {}; write {} = {}", field.key,
                                               shown_table(path.substr(0, path.rfind('.'))),
                                               field.key, toml_string(field.example));
    }

    template <TomlTable S>
    void tell_unknown_key(const TomlEntry& entry, const std::string& path) {
        tell_key(entry, unknown_key<Root, S>(entry, path));
    }

    template <Choosable T>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    T& result) {
        std::string word{word_of(result)};
        read_value(entry, node, field, word);
        choose_word(word, result);
    }

    template <class T>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::optional<T>& result) {
        T value{};
        read_value(entry, node, field, value);
        result = value;  // also if faulty: the key is given
    }

    template <class T>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::vector<T>& result) {
        const bool listed = !entry.origin.empty() &&
                            node.kind == TomlNode::Kind::string;  // --set apply_to=shear,area
        if (node.kind != TomlNode::Kind::array && !listed)
            return tell(entry, node,
                        fmt::format("{} = {} must be a list; write {} = {}", field.key, shown(node),
                                    field.key, field.example));
        result.clear();
        for (const TomlNode& item : listed ? listed_items(node.text) : node.items) {
            result.emplace_back();
            read_value(entry, item, field, result.back());
        }
    }
};

}  // namespace tt
