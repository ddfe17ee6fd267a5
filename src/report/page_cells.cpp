#include "report/page_cells.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include "observe/measures.hpp"

namespace tt {
namespace {

/// Rows of the table that belong to one time: from `begin` to before `end`.
struct TimeRows {
    double time;
    std::size_t begin, end;
};

std::vector<TimeRows> rows_by_time(const std::vector<double>& times) {
    std::vector<TimeRows> rows;
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (rows.empty() || rows.back().time != times[k]) rows.push_back({times[k], k, k});
        rows.back().end = k + 1;
    }
    return rows;
}

std::size_t nearest(const std::vector<TimeRows>& rows, double time) {
    const auto after = std::lower_bound(rows.begin(), rows.end(), time,
                                        [](const TimeRows& r, double t) { return r.time < t; });
    if (after == rows.begin()) return 0;
    const auto k = static_cast<std::size_t>(after - rows.begin());
    return after == rows.end() || time - rows[k - 1].time <= after->time - time ? k - 1 : k;
}

std::vector<TimeRows> chosen_rows(const std::vector<TimeRows>& rows,
                                  const std::vector<double>& frame_times, std::size_t most) {
    std::set<std::size_t> chosen;
    for (const double time : frame_times) chosen.insert(nearest(rows, time));
    const std::size_t stride = rows.size() / std::max<std::size_t>(most, 1) + 1;
    for (std::size_t k = 0; k < rows.size(); k += stride) chosen.insert(k);
    chosen.insert(rows.size() - 1);
    std::vector<TimeRows> list;
    for (const std::size_t k : chosen) list.push_back(rows[k]);
    return list;
}

/// Columns that say something of a cell: all but when, which, and of what kind.
std::vector<std::size_t> told_columns(const Table& cells) {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < cells.names.size(); ++c)
        if (cells.names[c] != "time" && cells.names[c] != "cell" && cells.names[c] != "kind")
            columns.push_back(c);
    return columns;
}

void append(std::string& bytes, const std::vector<float>& values) {
    const std::size_t size = bytes.size();
    bytes.resize(size + values.size() * sizeof(float));
    std::memcpy(bytes.data() + size, values.data(), values.size() * sizeof(float));
}

}  // namespace

Json cell_data(const Results& run, const std::vector<double>& frame_times,
               const PageLimits& limits) {
    const std::vector<double>& times = values(run.cells, "time");
    const std::vector<double>& numbers = values(run.cells, "cell");
    if (times.empty() || numbers.size() != times.size()) return nullptr;
    const auto rows = rows_by_time(times);
    std::size_t count = 0;
    for (const TimeRows& row : rows) count = std::max(count, row.end - row.begin);
    const auto columns = told_columns(run.cells);
    const std::size_t row_bytes = std::max<std::size_t>(sizeof(float) * count * columns.size(), 1);
    const auto chosen =
        chosen_rows(rows, frame_times, std::min(limits.cell_bytes / row_bytes, limits.rows));

    std::string bytes;
    Json keys = Json::array(), chosen_times = Json::array();
    for (const TimeRows& row : chosen) chosen_times.push_back(rounded(row.time));
    for (const std::size_t c : columns) {
        const std::string& key = run.cells.names[c];
        keys.push_back({{"key", key},
                        {"unit", run.cells.units[c]},
                        {"meaning", meaning_of<CellMeasures>(key)}});
        for (const TimeRows& row : chosen) {
            std::vector<float> of_cells(count, std::numeric_limits<float>::quiet_NaN());
            for (std::size_t k = row.begin; k < row.end; ++k)
                if (numbers[k] >= 0.0 && numbers[k] < static_cast<double>(count))
                    of_cells[static_cast<std::size_t>(numbers[k])] =
                        static_cast<float>(run.cells.columns[c][k]);
            append(bytes, of_cells);
        }
    }
    return {{"keys", keys}, {"count", count}, {"time", chosen_times}, {"values", base64(bytes)}};
}

}  // namespace tt
