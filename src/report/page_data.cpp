#include "report/page_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "observe/measures.hpp"
#include "report/frames.hpp"
#include "report/node_stretch.hpp"
#include "report/page_cells.hpp"
#include "report/places.hpp"
#include "report/words.hpp"

namespace tt {
namespace {

/// Every `stride`-th value, and the last.
Json thinned(const std::vector<double>& values, std::size_t stride) {
    Json list = Json::array();
    for (std::size_t k = 0; k < values.size(); k += stride) list.push_back(rounded(values[k]));
    if (!values.empty() && (values.size() - 1) % stride != 0)
        list.push_back(rounded(values.back()));
    return list;
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

/// Mean speed over the open sites of blocks of stride × stride sites; 0 where there are none.
std::vector<double> block_speeds(const FramesHeader& header, const Frame& frame, int stride) {
    const int nx = header.nx / stride, ny = header.ny / stride;
    std::vector<double> speeds(static_cast<std::size_t>(nx) * ny, 0.0), open(speeds.size(), 0.0);
    for (int j = 0; j < ny * stride; ++j)
        for (int i = 0; i < nx * stride; ++i) {
            const std::size_t site = static_cast<std::size_t>(j) * header.nx + i;
            const double speed = std::hypot(frame.velocity[2 * site], frame.velocity[2 * site + 1]);
            const std::size_t block = static_cast<std::size_t>(j / stride) * nx + i / stride;
            if (!std::isfinite(speed)) continue;
            speeds[block] += speed;
            open[block] += 1.0;
        }
    for (std::size_t k = 0; k < speeds.size(); ++k) speeds[k] /= std::max(open[k], 1.0);
    return speeds;
}

/// Speeds as bytes, 255 = the fastest.
std::string scaled_bytes(const std::vector<double>& speeds, double fastest) {
    std::string bytes;
    for (const double speed : speeds)
        bytes += static_cast<char>(
            static_cast<unsigned char>(fastest > 0.0 ? std::lround(255.0 * speed / fastest) : 0));
    return bytes;
}

/// Evenly spaced frames, at most limits.frames and those whose nodes fit, and the last.
std::vector<int> embedded_frames(int count, std::size_t nodes, const PageLimits& limits) {
    const std::size_t fitting = limits.node_bytes / std::max<std::size_t>(5 * nodes, 1);
    const int most = static_cast<int>(std::clamp<std::size_t>(fitting, 2, limits.frames));
    const int stride = (count + most - 1) / most;
    std::vector<int> frames;
    for (int k = 0; k < count; k += stride) frames.push_back(k);
    if (frames.back() != count - 1) frames.push_back(count - 1);
    return frames;
}

/// So many that some sixty frames of many cells fit, if that leaves an outline.
std::size_t nodes_per_cell(int cells, const PageLimits& limits) {
    const std::size_t fitting =
        limits.node_bytes / (5 * 60 * static_cast<std::size_t>(std::max(cells, 1)));
    return std::min(std::max<std::size_t>(fitting, 24), limits.nodes_per_cell);
}

/// The side of the blocks of sites over which speeds are averaged so that they fit.
int block_of_sites(const FramesHeader& header, std::size_t frames, const PageLimits& limits) {
    int block = 1;
    while (frames * (header.nx / block) * (header.ny / block) > limits.field_bytes &&
           block < header.ny)
        ++block;
    return block;
}

/// Which way the flow goes: {drive: "shear" | "channel" | "none", sign}. In shear the upper wall
/// moves along x times the sign, the lower one against it.
Json flow_direction(const Results& run) {
    const std::string drive = run.setting("flow.drive", "none");
    const bool shear = drive == "shear", given = !run.setting("flow.shear_rate").empty();
    const double along =
        shear ? setting_si(run.setting(given ? "flow.shear_rate" : "flow.shear_number"))
              : window_mean(run, "mean_velocity");
    const bool moves = drive != "none" && std::isfinite(along) && along != 0.0;
    return {{"drive", !moves ? "none" : shear ? "shear" : "channel"}, {"sign", along < 0 ? -1 : 1}};
}

/// What is gathered of the frames that are embedded.
struct Embedded {
    Json times = Json::array(), fields = Json::array();
    std::string nodes;
    std::vector<std::vector<double>> speeds, stretches;
    double fastest = 0.0;
};

Embedded gathered(const FramesReader& reader, const std::vector<int>& frames,
                  const NodeChoice& choice, double quantum, int block) {
    const FramesHeader& header = reader.header();
    Embedded e;
    for (const int k : frames) {
        const Frame frame = reader.frame(k);
        e.times.push_back(rounded(frame.time));
        append_positions(e.nodes, wrapped_nodes(header, frame), choice.nodes, quantum);
        e.stretches.push_back(chosen_stretches(header, frame, choice.nodes, choice.first));
        e.fields.push_back(frame.velocity.empty() ? Json(nullptr) : Json(e.speeds.size()));
        if (frame.velocity.empty()) continue;
        e.speeds.push_back(block_speeds(header, frame, block));
        for (const double speed : e.speeds.back()) e.fastest = std::max(e.fastest, speed);
    }
    return e;
}

}  // namespace

Json rounded(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

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

Json series_data(const Results& run, const PageLimits& limits) {
    Json columns = Json::array();
    const std::size_t rows = run.series.rows();
    const std::size_t stride = std::max<std::size_t>((rows + limits.rows - 1) / limits.rows, 1);
    const auto add = [&](const Table& table, std::size_t c, const std::string& meaning) {
        columns.push_back({{"key", table.names[c]},
                           {"unit", table.units[c]},
                           {"meaning", meaning},
                           {"values", thinned(table.columns[c], stride)}});
    };
    for (std::size_t c = 0; c < run.series.names.size(); ++c)
        add(run.series, c, meaning_of<RunMeasures>(run.series.names[c]));
    for (const Table* table : {&run.ports, &run.sections}) {  // their rows are of the same times
        if (table->rows() != rows) continue;
        for (std::size_t c = 0; c < table->names.size(); ++c)
            if (table->names[c] != "time" && table->names[c] != "step")
                add(*table, c, meaning_of_quantity(table->names[c]));
    }
    return columns;
}

Json player_data(const Results& run, const PageLimits& limits) {
    if (!run.frames || run.frames->count() == 0) return nullptr;
    const FramesHeader& header = run.frames->header();
    const NodeChoice choice = chosen_nodes(header, nodes_per_cell(cell_count(header), limits));
    const auto frames = embedded_frames(run.frames->count(), choice.nodes.size(), limits);
    const int block = block_of_sites(header, frames.size(), limits);
    const double quantum = 1.6 * std::max(header.length, header.width) / 32767.0;
    const Embedded e = gathered(*run.frames, frames, choice, quantum, block);
    std::string speed_bytes;
    for (const std::vector<double>& speed : e.speeds) speed_bytes += scaled_bytes(speed, e.fastest);
    return {{"length", header.length},
            {"width", header.width},
            {"quantum", rounded(quantum)},
            {"first", choice.first},
            {"kind", header.kind},
            {"kinds", kind_names(header)},
            {"walls", header.walls},
            {"wall_first", header.wall_first},
            {"origin", header.origin.empty() ? std::vector<double>{0.0, 0.0} : header.origin},
            {"walled", run.setting("domain.sides", "walls") == "walls" && header.origin.empty()},
            {"flow", flow_direction(run)},
            {"places", places_data(run)},
            {"times", e.times},
            {"fields", e.fields},
            {"nodes", base64(e.nodes)},
            {"stretch", stretch_data(run, e.stretches)},
            {"columns", header.nx / block},
            {"rows", header.ny / block},
            {"fastest", rounded(e.fastest)},
            {"speed", base64(speed_bytes)},
            {"recorded", run.frames->count()},
            {"block", block},
            {"nodes_recorded", header.first.back()}};
}

Json run_data(const Results& run, const std::string& label, const PageLimits& limits) {
    Json player = player_data(run, limits);
    std::vector<double> frame_times;
    if (!player.is_null()) frame_times = player["times"].get<std::vector<double>>();
    return {{"label", label},
            {"columns", series_data(run, limits)},
            {"cells", cell_data(run, frame_times, limits)},
            {"player", std::move(player)}};
}

}  // namespace tt
