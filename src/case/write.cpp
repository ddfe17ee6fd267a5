#include "case/write.hpp"

#include <fmt/format.h>

#include "case/field_types.hpp"
#include "case/schema.hpp"
#include "case/value_text.hpp"

namespace tt {
namespace {

template <TomlTable S>
void write_table(const S& table, const std::string& path, std::string& text) {
    for_each_field<S>([&](const auto& field) {
        const auto& value = table.*field.member;
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (!TomlTable<T> && !is_tables<T>) {
            const std::string written = value_text(value, field.example);
            const std::string line = written.empty()
                                         ? fmt::format("# {} = (auto or not given)", field.key)
                                         : fmt::format("{} = {}", field.key, written);
            text += fmt::format("{:<42} # {}\n", line, field.meaning);
        }
        if constexpr (has_keys<T>)
            std::visit(
                [&](const auto& chosen) {
                    if constexpr (Fielded<std::remove_cvref_t<decltype(chosen)>>)
                        write_table(chosen, path, text);
                },
                value);
    });
    for_each_field<S>([&](const auto& field) {
        const auto& value = table.*field.member;
        if constexpr (TomlTable<std::remove_cvref_t<decltype(value)>>) {
            const std::string name =
                path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key);
            text += fmt::format("\n{:<42} # {}\n", fmt::format("[{}]", name), field.meaning);
            write_table(value, name, text);
        }
        if constexpr (is_named_tables<std::remove_cvref_t<decltype(value)>>)
            for (const auto& item : value) {
                const std::string name = fmt::format("{}.{}", field.key, item.name);
                text += fmt::format("\n[{}]\n", name);
                write_table(item, name, text);
            }
        if constexpr (is_listed_tables<std::remove_cvref_t<decltype(value)>>)
            for (const auto& item : value) {
                const std::string name =
                    path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key);
                text += fmt::format("\n[[{}]]\n", name);
                write_table(item, name, text);
            }
    });
}

/// Of a table among its like: its name, or which it is.
template <class S>
std::string name_in_list(const S& table, std::size_t n) {
    if constexpr (requires { table.name; })
        return table.name;
    else
        return fmt::format("{}", n + 1);
}

template <TomlTable S>
void write_lines(const S& table, const std::string& path, std::string& text) {
    for_each_field<S>([&](const auto& field) {
        const auto& value = table.*field.member;
        const std::string key = path + std::string(field.key);
        if constexpr (TomlTable<std::remove_cvref_t<decltype(value)>>) {
            write_lines(value, key + ".", text);
        } else if constexpr (is_named_tables<std::remove_cvref_t<decltype(value)>>) {
            for (const auto& item : value) write_lines(item, key + "." + item.name + ".", text);
        } else if constexpr (is_listed_tables<std::remove_cvref_t<decltype(value)>>) {
            for (std::size_t n = 0; n < value.size(); ++n)
                write_lines(value[n], key + "." + name_in_list(value[n], n) + ".", text);
        } else {
            const std::string written = value_text(value, field.example);
            text += fmt::format("{} = {}\n", key, written.empty() ? "auto" : written);
        }
        if constexpr (has_keys<std::remove_cvref_t<decltype(value)>>)
            std::visit(
                [&](const auto& chosen) {
                    if constexpr (Fielded<std::remove_cvref_t<decltype(chosen)>>)
                        write_lines(chosen, path, text);
                },
                value);
    });
}

}  // namespace

std::string to_toml(const Case& given) {
    std::string text;
    write_table(given, "", text);
    return text;
}

std::string key_lines(const Case& given) {
    std::string text;
    write_lines(given, "", text);
    return text;
}

}  // namespace tt
