#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace tt {

// Names of tables that the user names, [port.NAME]: they become parts of columns and of files.

inline constexpr std::size_t longest_table_name = 32;

inline bool is_table_name(std::string_view name) {
    const auto proper = [](char letter) {
        return letter == '_' || letter == '-' || (letter >= '0' && letter <= '9') ||
               (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    };
    return !name.empty() && name.size() <= longest_table_name &&
           std::all_of(name.begin(), name.end(), proper);
}

inline std::string table_name_fault(std::string_view table) {
    return fmt::format("the name of a {} has letters, digits, _ and -, at most {}; write [{}.{}]",
                       table, longest_table_name, table, table == "port" ? "inlet" : "one");
}

/// 'a', 'b', 'c'.
template <class T>
std::string listed_names(const std::vector<T>& tables) {
    std::string text;
    for (const T& table : tables)
        text += fmt::format("{}'{}'", text.empty() ? "" : ", ", table.name);
    return text;
}

}  // namespace tt
