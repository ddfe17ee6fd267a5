#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// Columns of numbers with a name and a unit each, as in series.csv.
struct Table {
    struct Column {
        std::string name;
        std::string unit;  ///< empty: dimensionless
        std::vector<double> values;
    };
    std::vector<Column> columns;

    std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
    /// The column of that name, or nullptr.
    const Column* find(std::string_view name) const;
    /// The values of the column of that name; empty if there is none.
    const std::vector<double>& values(std::string_view name) const;
};

/// Reads comma-separated numbers under one header line `name [unit],…` (`name` alone: dimensionless). A last line
/// that was cut short, as a killed run leaves it, is left out. Throws IoError: no such file, no header, or a word where
/// a number must stand, with file:line.
Table read_table(const std::filesystem::path& path);

}  // namespace tt
