#include "report/page_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "observe/measures.hpp"
#include "report/frames.hpp"

namespace tt {
namespace {

Json rounded(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

/// Every `stride`-th value, and the last.
Json thinned(const std::vector<double>& values, std::size_t stride) {
    Json list = Json::array();
    for (std::size_t k = 0; k < values.size(); k += stride) list.push_back(rounded(values[k]));
    if (!values.empty() && (values.size() - 1) % stride != 0)
        list.push_back(rounded(values.back()));
    return list;
}

std::string meaning_of(const std::string& key) {
    std::string meaning;
    for_each_field<RunMeasures>([&](const auto& entry) {
        if (entry.key == key) meaning = entry.meaning;
    });
    return meaning;
}

/// λ_C of every cell over time: {time, values: one list a cell}.
Json cell_stretches(const Results& run, std::size_t most_rows) {
    const std::vector<double>& time = values(run.cells, "time");
    const std::vector<double>& cell = values(run.cells, "cell");
    const std::vector<double>& stretch = values(run.cells, "lambda_C");
    if (time.empty() || cell.empty() || stretch.empty()) return nullptr;
    std::map<double, std::vector<double>> by_cell;
    std::vector<double> times;
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (cell[k] == cell.front()) times.push_back(time[k]);
        by_cell[cell[k]].push_back(stretch[k]);
    }
    const std::size_t stride = times.size() * by_cell.size() / (4 * most_rows) + 1;
    Json lists = Json::array();
    for (const auto& [number, curve] : by_cell) lists.push_back(thinned(curve, stride));
    return {{"time", thinned(times, stride)}, {"values", lists}};
}

/// λ_C of each cell at the row of cells.csv nearest to `time`; empty where the run did not write
/// any.
Json stretches_at(const Results& run, double time, int cells) {
    const std::vector<double>& times = values(run.cells, "time");
    const std::vector<double>& cell = values(run.cells, "cell");
    const std::vector<double>& stretch = values(run.cells, "lambda_C");
    if (times.empty() || cell.size() != times.size() || stretch.size() != times.size())
        return Json::array();
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    double nearest = after == times.end() ? times.back() : *after;
    if (after != times.begin() && std::abs(*(after - 1) - time) < std::abs(nearest - time))
        nearest = *(after - 1);
    std::vector<double> found(static_cast<std::size_t>(cells), std::nan(""));
    for (auto row = std::lower_bound(times.begin(), times.end(), nearest);
         row != times.end() && *row == nearest; ++row) {
        const auto k = static_cast<std::size_t>(row - times.begin());
        if (cell[k] >= 0 && cell[k] < cells) found[static_cast<std::size_t>(cell[k])] = stretch[k];
    }
    return thinned(found, 1);
}

/// What of the nodes is embedded.
struct NodeChoice {
    std::vector<int> nodes;  ///< every so-many-th of each cell
    std::vector<int> first;  ///< offsets of the cells in `nodes`
};

NodeChoice chosen_nodes(const FramesHeader& header, std::size_t most_per_cell) {
    NodeChoice choice;
    choice.first.push_back(0);
    for (int c = 0; c < cell_count(header); ++c) {
        const int begin = header.first[static_cast<std::size_t>(c)];
        const int end = header.first[static_cast<std::size_t>(c) + 1];
        const int stride = (end - begin - 1) / static_cast<int>(most_per_cell) + 1;
        for (int k = begin; k < end; k += stride) choice.nodes.push_back(k);
        choice.first.push_back(static_cast<int>(choice.nodes.size()));
    }
    return choice;
}

void append_positions(std::string& bytes, const std::vector<Vec2>& nodes,
                      const std::vector<int>& chosen, double quantum) {
    for (const int k : chosen) {
        const Vec2 p = nodes[static_cast<std::size_t>(k)];
        for (const double coordinate : {p.x, p.y}) {
            const double steps = std::isfinite(coordinate)
                                     ? std::clamp(coordinate / quantum, -32768.0, 32767.0)
                                     : 0.0;
            const auto value =
                static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(steps)));
            bytes += static_cast<char>(value & 0xff);
            bytes += static_cast<char>(value >> 8);
        }
    }
}

/// Mean speed of blocks of stride × stride sites.
std::vector<double> block_speeds(const FramesHeader& header, const Frame& frame, int stride) {
    const int nx = header.nx / stride, ny = header.ny / stride;
    std::vector<double> speeds(static_cast<std::size_t>(nx) * ny, 0.0);
    for (int j = 0; j < ny * stride; ++j)
        for (int i = 0; i < nx * stride; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * header.nx + i;
            speeds[static_cast<std::size_t>(j / stride) * nx + i / stride] +=
                std::hypot(frame.velocity[2 * site], frame.velocity[2 * site + 1]) /
                (stride * stride);
        }
    return speeds;
}

/// Speeds as bytes, 255 = the fastest.
std::string scaled_bytes(const std::vector<double>& speeds, double fastest) {
    std::string bytes;
    for (const double speed : speeds)
        bytes += static_cast<char>(static_cast<unsigned char>(
            fastest > 0.0 && std::isfinite(speed) ? 255.0 * speed / fastest : 0.0));
    return bytes;
}

}  // namespace

std::string base64(std::string_view bytes) {
    static constexpr char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t b = 0; b < 3; ++b)
            group =
                group << 8 | (k + b < bytes.size() ? static_cast<unsigned char>(bytes[k + b]) : 0u);
        for (std::size_t b = 0; b < 4; ++b)
            text += k + b <= bytes.size() ? letters[group >> (18 - 6 * b) & 63] : '=';
    }
    return text;
}

Json chart_data(const Results& run, const std::string& label, const PageLimits& limits) {
    Json columns = Json::array();
    const std::size_t stride = (run.series.rows() + limits.rows - 1) / limits.rows;
    for (std::size_t c = 0; c < run.series.names.size(); ++c) {
        const std::string& key = run.series.names[c];
        columns.push_back(
            {{"key", key},
             {"unit", run.series.units[c]},
             {"meaning", meaning_of(key)},
             {"values", thinned(run.series.columns[c], std::max<std::size_t>(stride, 1))}});
    }
    return {{"label", label}, {"columns", columns}, {"cells", cell_stretches(run, limits.rows)}};
}

Json player_data(const Results& run, const std::string& label, const PageLimits& limits) {
    if (!run.frames || run.frames->count() == 0) return nullptr;
    const FramesHeader& header = run.frames->header();
    const NodeChoice choice = chosen_nodes(header, limits.nodes_per_cell);
    const auto count = static_cast<std::size_t>(run.frames->count());
    const std::size_t by_nodes =
        limits.node_bytes / std::max<std::size_t>(4 * choice.nodes.size(), 1);
    const std::size_t most = std::max<std::size_t>(std::min(limits.frames, by_nodes), 2);
    const std::size_t stride = (count + most - 1) / most;
    const std::size_t embedded = (count + stride - 1) / stride;
    int block = 1;
    while (embedded * (header.nx / block) * (header.ny / block) > limits.field_bytes &&
           block < header.ny)
        ++block;

    const double quantum = 1.6 * std::max(header.length, header.width) / 32767.0;
    std::string nodes;
    std::vector<std::vector<double>> speeds;
    Json times = Json::array(), stretches = Json::array(), fields = Json::array();
    double fastest = 0.0;
    for (std::size_t k = 0; k < count; k += stride) {
        const Frame frame = run.frames->frame(static_cast<int>(k));
        times.push_back(rounded(frame.time));
        stretches.push_back(stretches_at(run, frame.time, cell_count(header)));
        append_positions(nodes, wrapped_nodes(header, frame), choice.nodes, quantum);
        fields.push_back(frame.velocity.empty() ? Json(nullptr) : Json(speeds.size()));
        if (frame.velocity.empty()) continue;
        speeds.push_back(block_speeds(header, frame, block));
        for (const double speed : speeds.back()) fastest = std::max(fastest, speed);
    }
    std::string speed_bytes;
    for (const std::vector<double>& speed : speeds) speed_bytes += scaled_bytes(speed, fastest);
    return {{"label", label},
            {"length", header.length},
            {"width", header.width},
            {"quantum", rounded(quantum)},
            {"first", choice.first},
            {"walls", header.walls},
            {"wall_first", header.wall_first},
            {"times", times},
            {"stretches", stretches},
            {"fields", fields},
            {"nodes", base64(nodes)},
            {"columns", header.nx / block},
            {"rows", header.ny / block},
            {"fastest", rounded(fastest)},
            {"speed", base64(speed_bytes)},
            {"recorded", count},
            {"block", block},
            {"nodes_recorded", header.first.back()}};
}

}  // namespace tt
