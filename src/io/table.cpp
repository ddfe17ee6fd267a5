#include "io/table.hpp"

#include <charconv>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// Cuts the text before the next `mark` off the front of `rest`.
std::string_view next_part(std::string_view& rest, char mark) {
    const auto end = rest.find(mark);
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    return part;
}

std::vector<Table::Column> header_columns(std::string_view header) {
    std::vector<Table::Column> columns;
    while (!header.empty()) {
        std::string_view title = trimmed(next_part(header, ','));
        const std::string_view name = trimmed(next_part(title, '['));
        columns.push_back({std::string(name), std::string(title.substr(0, title.find(']'))), {}});
    }
    return columns;
}

/// Reads one line of numbers; false if it has fewer fields than columns, or one is not a number.
bool read_row(std::string_view line, std::vector<double>& row) {
    for (double& value : row) {
        if (line.empty()) return false;
        const std::string_view field = trimmed(next_part(line, ','));
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
        if (error != std::errc{} || end != field.data() + field.size()) return false;
    }
    return true;
}

}  // namespace

const Table::Column* Table::find(std::string_view name) const {
    for (const Column& column : columns)
        if (column.name == name) return &column;
    return nullptr;
}

const std::vector<double>& Table::values(std::string_view name) const {
    static const std::vector<double> none;
    const Column* column = find(name);
    return column ? column->values : none;
}

Table read_table(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(fmt::format("{}: cannot be opened", path.string()));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string_view rest = text;
    Table table{header_columns(next_part(rest, '\n'))};
    if (table.columns.empty()) throw IoError(fmt::format("{}: has no header line", path.string()));

    std::vector<double> row(table.columns.size());
    for (int line = 2; rest.find('\n') != std::string_view::npos; ++line) {
        const std::string_view part = next_part(rest, '\n');
        if (trimmed(part).empty()) continue;
        if (!read_row(part, row))
            throw IoError(fmt::format("{}:{}: expected {} numbers", path.string(), line, row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    }
    return table;
}

}  // namespace tt
