#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/letter.hpp"
#include "base/words.hpp"
#include "case/field_types.hpp"
#include "io/toml.hpp"

namespace tt {

/// The paths of all tables that have a field `key`.
template <TomlTable S>
void find_key(std::string_view key, const std::string& path, std::vector<std::string>& found) {
    for_each_key<S>([&](const auto& field) {
        using T = value_type_of<decltype(field)>;
        if (field.key == key && !path.empty()) found.push_back(path);
        if constexpr (TomlTable<T>)
            find_key<T>(
                key, path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key),
                found);
    });
}

/// How a table is written: "[flow]", and "[[target]]" of one of several without names, "target.2".
inline std::string shown_table(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    const bool listed = dot != std::string::npos && dot + 1 < path.size() &&
                        path.find_first_not_of("0123456789", dot + 1) == std::string::npos;
    return listed ? fmt::format("[[{}]]", path.substr(0, dot)) : fmt::format("[{}]", path);
}

/// What to say of a key that the table S, at `path`, does not have: the nearest that it has, or
/// where in Root the key belongs.
template <TomlTable Root, TomlTable S>
std::string unknown_key(const TomlEntry& entry, const std::string& path) {
    std::vector<std::string_view> keys;
    for_each_key<S>([&](const auto& field) { keys.push_back(field.key); });
    std::vector<std::string> elsewhere;
    find_key<Root>(entry.key, "", elsewhere);
    std::string message =
        path.empty()
            ? fmt::format("unknown {} '{}'",
                          entry.value.kind == TomlNode::Kind::table ? "table" : "key",
                          readable(entry.key))
            : fmt::format("unknown key '{}' in {}", readable(entry.key), shown_table(path));
    if (const auto near = closest(entry.key, keys); near && elsewhere.empty())
        message += fmt::format("; did you mean '{}'?", *near);
    else if (!elsewhere.empty())
        message += fmt::format("; it belongs to [{}]", fmt::join(elsewhere, "] or ["));
    else
        message += fmt::format("; known here: {}", fmt::join(keys, ", "));
    return message;
}

}  // namespace tt
