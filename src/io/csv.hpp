#pragma once

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/field_list.hpp"
#include "base/units.hpp"

namespace tt {

/// `time [s],cell,mean_velocity [m/s]`: one column per entry of the row's field list, with its
/// unit.
template <class Row>
std::string csv_header() {
    std::string text;
    for_each_field<Row>([&](const auto& entry) {
        using T = std::remove_cvref_t<decltype(Row{}.*entry.member)>;
        if (!text.empty()) text += ',';
        text += entry.key;
        if constexpr (requires { T::dimension; }) {
            const std::string unit = si_unit(T::dimension);
            if (!unit.empty()) text += fmt::format(" [{}]", unit);
        }
    });
    return text + '\n';
}

/// The row in SI units, each number in the fewest digits that read back to the same bits.
template <class Row>
std::string csv_row(const Row& row) {
    std::string text;
    for_each_field<Row>([&](const auto& entry) {
        using T = std::remove_cvref_t<decltype(row.*entry.member)>;
        if (!text.empty()) text += ',';
        const auto end = std::back_inserter(text);
        if constexpr (requires { T::dimension; }) {
            fmt::format_to(end, "{}", (row.*entry.member).si);
        } else {
            fmt::format_to(end, "{}", row.*entry.member);
        }
    });
    return text + '\n';
}

/// A table read back: columns of numbers by name.
struct Table {
    std::vector<std::string> names;
    std::vector<std::string> units;  ///< empty for a plain number
    std::vector<std::vector<double>> columns;

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
    bool has(std::string_view name) const;
    /// IoError if there is no such column.
    const std::vector<double>& column(std::string_view name) const;
    const std::string& unit(std::string_view name) const;
};

/// Reads what csv_header and csv_row wrote. Lines starting with '#' are skipped. IoError with
/// path:line for a ragged line or a cell that is no number; a last line that is still being written
/// is left out.
Table read_csv(const std::filesystem::path& path);

}  // namespace tt
