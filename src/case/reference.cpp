#include "case/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/words.hpp"
#include "case/schema.hpp"
#include "case/value_text.hpp"

namespace tt {
namespace {

std::string full_name(const std::string& table, std::string_view key) {
    return table.empty() ? std::string(key) : fmt::format("{}.{}", table, key);
}

std::string bounds_text(const Range& range, std::string_view unit) {
    const auto text = [&](double v) { return to_text(v, v == 0.0 ? std::string_view{} : unit); };
    if (range.low == range.high) return text(range.low);
    if (std::isinf(range.low)) return {};
    const std::string low = fmt::format("{} {}", range.low_open ? ">" : ">=", text(range.low));
    return std::isinf(range.high) ? low : fmt::format("{}, <= {}", low, text(range.high));
}

/// A sample value: the default; where there is none, the example.
template <class F, class T>
std::string sample(const F& field, const T& value, bool required) {
    const bool none = required || field.choices == "auto";
    const std::string text = none ? std::string{} : value_text(value, field.example);
    if (!text.empty() && text != "\"\"" && text != "[]") return text;
    using Item = item_type<T>;
    const bool as_is = field.example.substr(0, 1) == "[" ||
                       (std::is_arithmetic_v<Item> && unit_of(field.example).empty());
    return as_is ? std::string(field.example) : toml_string(field.example);
}

template <class F, class T>
KeyLine key_line(const std::string& table, const F& field, const T& value) {
    KeyLine line;
    line.full_name = full_name(table, field.key);
    if constexpr (is_quantity<T>)
        line.required = !field.range.contains(value.si) && field.choices != "auto";
    if constexpr (std::is_same_v<T, double>) line.required = !field.range.contains(value);
    line.example = fmt::format("{} = {}", field.key, sample(field, value, line.required));
    line.meaning = field.meaning;
    line.bounds = bounds_text(field.range, unit_of(field.example));
    constexpr bool flag = std::is_same_v<item_type<T>, bool>;
    const std::string_view words =
        flag ? std::string_view("true|false") : words_of_field(field, value);
    if (!words.empty()) {
        for (const std::string_view word : split(words, '|')) line.words.emplace_back(word);
        line.bounds +=
            fmt::format("{}{}", line.bounds.empty() ? "" : " | ", fmt::join(line.words, " | "));
    }
    if (line.required)
        line.bounds += line.bounds.empty() ? "must be given" : "; must be given";
    else if constexpr (is_optional<T>)
        line.bounds += line.bounds.empty() ? "may be left out" : "; may be left out";
    return line;
}

/// The keys of the alternatives of a choice, each with the words that it belongs to.
template <StructChoice V>
void collect_of_choice(std::string_view choice_key, KeyTable& table) {
    for_each_alternative<V>([&]<class A>() {
        if constexpr (Fielded<A>) {
            const A defaults{};
            for_each_field<A>([&](const auto& field) {
                const auto words = words_with_key<V>(field.key);
                if (words.front() != A::name) return;
                KeyLine line = key_line(table.name, field, defaults.*field.member);
                line.meaning = fmt::format("with {} = \"{}\": {}", choice_key,
                                           fmt::join(words, "\" or \""), line.meaning);
                table.keys.push_back(std::move(line));
            });
        }
    });
}

/// The fields of a struct that are no other table's too.
template <class S, class F>
void for_each_own_field(F&& f) {
    if constexpr (requires { FieldList<S>::own; })
        std::apply([&](const auto&... entry) { (f(entry), ...); }, FieldList<S>::own);
    else
        for_each_field<S>(f);
}

template <TomlTable S>
void collect(const std::string& path, std::string_view meaning, std::vector<KeyTable>& tables,
             const std::string& header) {
    const S defaults{};
    KeyTable table{path, header, std::string(meaning), {}};
    for_each_own_field<S>([&](const auto& field) {
        const auto& value = defaults.*field.member;
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (!TomlTable<T> && !is_tables<T>)
            table.keys.push_back(key_line(path, field, value));
        if constexpr (has_keys<T>) collect_of_choice<T>(field.key, table);
    });
    tables.push_back(std::move(table));
    for_each_own_field<S>([&](const auto& field) {
        using T = std::remove_cvref_t<decltype(defaults.*field.member)>;
        const std::string name = full_name(path, field.key);
        if constexpr (TomlTable<T>) {
            collect<T>(name, field.meaning, tables, fmt::format("[{}]", name));
        }
        if constexpr (is_named_tables<T>)
            collect<item_type<T>>(name + ".NAME", field.meaning, tables,
                                  fmt::format("[{}.NAME]", name));
        if constexpr (is_listed_tables<T>)
            collect<item_type<T>>(name + (requires(item_type<T> t) { t.name; } ? ".NAME" : ".N"),
                                  field.meaning, tables, fmt::format("[[{}]]", name));
    });
}

/// Whatever the case of its letters.
bool contains(std::string_view text, std::string_view word) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::search(text.begin(), text.end(), word.begin(), word.end(),
                       [&](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

/// The tables with those of their keys of which `wanted(key)` holds.
template <class Wanted>
std::vector<KeyTable> chosen(Wanted wanted) {
    std::vector<KeyTable> tables = reference_tables();
    for (KeyTable& table : tables)
        std::erase_if(table.keys, [&](const KeyLine& line) { return !wanted(line); });
    std::erase_if(tables, [](const KeyTable& table) { return table.keys.empty(); });
    return tables;
}

std::string listed(const std::vector<KeyTable>& tables) {
    constexpr std::size_t width = 79;
    constexpr std::size_t indent = 6;
    const std::string margin(indent, ' ');
    std::string text;
    for (const KeyTable& table : tables) {
        const std::string header =
            table.name.empty() ? table.meaning : fmt::format("{}  {}", table.header, table.meaning);
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", wrapped(header, width, 2));
        for (const KeyLine& line : table.keys) {
            text += fmt::format("  {}\n{}{}\n", line.example, margin,
                                wrapped(line.meaning, width, indent));
            if (!line.bounds.empty())
                text += fmt::format("{}{}\n", margin, wrapped(line.bounds, width, indent));
        }
    }
    return text;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

}  // namespace

const std::string_view how_to_write_values =
    "A quantity is a string with its unit: `\"80 um\"`, `\"6e-3 dyn/cm\"`, `\"500 /s\"`. Any unit "
    "of "
    "the right kind will\n"
    "do, with the prefixes z a f p n u m c d k M G on m, g, s, Hz, N, dyn, J, erg, eV, Pa, bar, "
    "mH2O, P, St and L; also\n"
    "min, h, mmHg, atm, %, deg, rad and kT, which is at 310 K: 4.28e-21 J. Between units stands a "
    "space, `*` or `.`; powers\n"
    "are `m^3`, `m3` or `s-1`. Under a `/` stands one unit, or several in brackets. A key that "
    "says \"may be left out\" may\n"
    "also be `\"auto\"`. The values shown are those in force without the key, or an example where "
    "there is none.";

std::vector<KeyTable> reference_tables() {
    std::vector<KeyTable> tables;
    collect<Case>("", "keys at the top of the file", tables, "");
    return tables;
}

std::string reference_text(std::string_view word) {
    const auto named = [&](const KeyLine& line) { return contains(line.full_name, word); };
    const auto told_of = [&](const KeyLine& line) {
        return !named(line) && (contains(line.meaning, word) || contains(line.bounds, word));
    };
    const std::string text = listed(chosen(named));
    if (text.empty()) return listed(chosen(told_of));
    std::string others;
    for (const KeyTable& table : chosen(told_of))
        for (const KeyLine& line : table.keys)
            others += (others.empty() ? "" : ", ") + line.full_name;
    if (others.empty()) return text;
    return text + "\n" + wrapped("What these do has it too: " + others, 79, 2) + "\n";
}

std::string reference_markdown() {
    std::string text =
        "# Keys of the case file\n\n"
        "Made by `tanktread keys --markdown` from the lists that the program reads by; a test "
        "holds both together.\n\n" +
        std::string(how_to_write_values) + "\n";
    for (const KeyTable& table : reference_tables()) {
        const std::string header = table.name.empty() ? std::string("At the top") : table.header;
        text += fmt::format("\n## {}\n\n{}.\n\n| key | meaning | values |\n|---|---|---|\n", header,
                            table.meaning);
        for (const KeyLine& line : table.keys)
            text += fmt::format("| `{}` | {} | {} |\n", line.example, escaped(line.meaning),
                                escaped(line.bounds));
    }
    return text;
}

}  // namespace tt
