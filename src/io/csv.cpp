#include "io/csv.hpp"

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "base/words.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t comma = line.find(',');
        cells.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

void read_header(std::string_view line, Table& table) {
    for (std::string_view cell : split(line)) {
        cell = trimmed(cell);
        std::string_view unit;
        const std::size_t open = cell.find(" [");
        if (open != std::string_view::npos && cell.back() == ']') {
            unit = cell.substr(open + 2, cell.size() - open - 3);
            cell = cell.substr(0, open);
        }
        table.names.emplace_back(cell);
        table.units.emplace_back(unit);
    }
    table.columns.resize(table.names.size());
}

void read_row(std::string_view line, const std::string& place, Table& table) {
    const std::vector<std::string_view> cells = split(line);
    if (cells.size() != table.names.size()) {
        throw IoError(fmt::format("{}: {} cells where the header has {}", place, cells.size(),
                                  table.names.size()));
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::string_view cell = trimmed(cells[k]);
        double value = 0.0;
        const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (code != std::errc{} || end != cell.data() + cell.size()) {
            throw IoError(fmt::format("{}: '{}' in column '{}' is not a number", place, cell,
                                      table.names[k]));
        }
        table.columns[k].push_back(value);
    }
}

std::size_t index_of(const Table& table, std::string_view name) {
    const auto found = std::find(table.names.begin(), table.names.end(), name);
    if (found == table.names.end())
        throw IoError(fmt::format("the table has no column '{}'", name));
    return static_cast<std::size_t>(found - table.names.begin());
}

}  // namespace

bool Table::has(std::string_view name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<double>& Table::column(std::string_view name) const {
    return columns[index_of(*this, name)];
}

const std::string& Table::unit(std::string_view name) const { return units[index_of(*this, name)]; }

Table read_csv(const std::filesystem::path& path) {
    const std::string text = read_file(path);
    Table table;
    std::string_view rest = text;
    for (int number = 1; !rest.empty(); ++number) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (line.empty() || line.front() == '#') continue;
        const std::string place = fmt::format("{}:{}", path.string(), number);
        if (end == std::string_view::npos && split(line).size() < table.names.size()) break;
        if (has_open_quote(line))
            throw IoError(place + ": a quote (\") is left open; close it, or leave it out");
        if (table.names.empty())
            read_header(line, table);
        else
            read_row(line, place, table);
    }
    return table;
}

}  // namespace tt
