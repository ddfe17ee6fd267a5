#include "io/frames_format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt::frames {
namespace {

bool is_number(const std::string& text) {
    return !text.empty() && text.size() < 16 &&
           text.find_first_not_of("0123456789") == std::string::npos;
}

/// IoError unless the header can be one: its numbers set the sizes of all that is read next.
void examine(const FramesHeader& header) {
    const auto& first = header.first;
    const bool sound = header.nx > 0 && header.ny > 0 && header.dx > 0.0 && header.length > 0.0 &&
                       header.width > 0.0 && std::isfinite(header.width) &&
                       std::isfinite(header.length) && !first.empty() && first.front() == 0 &&
                       std::is_sorted(first.begin(), first.end()) &&
                       (header.rest_length.empty() ||
                        header.rest_length.size() == static_cast<std::size_t>(first.back())) &&
                       (header.kind.empty() || header.kind.size() + 1 == first.size()) &&
                       std::all_of(header.kind.begin(), header.kind.end(),
                                   [](std::int32_t kind) { return kind >= 0; });
    const auto& wall = header.wall_first;
    const bool walls_sound =
        wall.empty() || (wall.front() == 0 && std::is_sorted(wall.begin(), wall.end()) &&
                         header.walls.size() == 2 * static_cast<std::size_t>(wall.back()));
    const bool place_sound =
        header.origin.empty() || (header.origin.size() == 2 && std::isfinite(header.origin[0]) &&
                                  std::isfinite(header.origin[1]));
    hdf5::expect(place_sound, "make sense of", "the origin of the frames");
    hdf5::expect(walls_sound, "make sense of", "the walls of the frames");
    hdf5::expect(sound, "make sense of", "the header of the frames");
}

/// x, y of the nodes that a frame holds: of all cells, or of those that had come by then.
std::vector<double> read_nodes(hid_t group, const char* name, const FramesHeader& header) {
    std::vector<double> pairs = hdf5::read_dataset<double>(group, name).values;
    const auto nodes = static_cast<std::int32_t>(pairs.size() / 2);
    hdf5::expect(pairs.size() % 2 == 0 &&
                     std::binary_search(header.first.begin(), header.first.end(), nodes),
                 "read whole cells of", name);
    return pairs;
}

template <class T>
std::vector<T> read_values(hid_t group, const char* name, std::size_t count) {
    std::vector<T> values = hdf5::read_dataset<T>(group, name).values;
    hdf5::expect(values.size() == count, "read as many values as it should of", name);
    return values;
}

}  // namespace

namespace fs = std::filesystem;

std::string group_name(std::int64_t number) { return fmt::format("frames/{:06d}", number); }

fs::path folder_of(const fs::path& frames_h5) { return frames_h5.parent_path() / "frames"; }

fs::path merged_part(const fs::path& folder) { return folder / "merged.h5"; }

void write_cells(hid_t file, const FramesHeader& header) {
    for (const char* name : {"first", "rest_length", "kind"})
        if (hdf5::exists(file, name)) hdf5::remove(file, name);
    hdf5::write_dataset(file, "first", header.first);
    hdf5::write_dataset(file, "rest_length", {header.rest_length.size()}, header.rest_length, "m");
    hdf5::write_dataset(file, "kind", header.kind);
}

void write_header(hid_t file, const FramesHeader& header, Kind kind) {
    hdf5::write_attribute(file, "name", header.name);
    hdf5::write_attribute(file, "dx", header.dx);
    hdf5::write_attribute(file, "dt", header.dt);
    hdf5::write_attribute(file, "lengths", std::array{header.length, header.width});
    hdf5::write_attribute(file, "nx", static_cast<std::int64_t>(header.nx));
    hdf5::write_attribute(file, "ny", static_cast<std::int64_t>(header.ny));
    hdf5::write_attribute(file, "kinds", header.kinds);
    hdf5::write_attribute(file, "merged", static_cast<std::int64_t>(kind));
    write_cells(file, header);
    if (!header.wall_first.empty()) {
        hdf5::write_dataset(file, "walls", {header.walls.size() / 2, 2}, header.walls, "m");
        hdf5::write_dataset(file, "wall_first", header.wall_first);
    }
    if (!header.origin.empty())
        hdf5::write_dataset(file, "origin", {header.origin.size()}, header.origin, "m");
    hdf5::create_group(file, "frames");
}

FramesHeader read_header(hid_t file) {
    FramesHeader header;
    header.name = hdf5::read_text(file, "name");
    header.dx = hdf5::read_double(file, "dx");
    header.dt = hdf5::read_double(file, "dt");
    const std::vector<double> lengths = hdf5::read_doubles(file, "lengths");
    hdf5::expect(lengths.size() == 2, "read two values of", "lengths");
    header.length = lengths[0];
    header.width = lengths[1];
    header.nx = static_cast<int>(hdf5::read_integer(file, "nx"));
    header.ny = static_cast<int>(hdf5::read_integer(file, "ny"));
    header.first = hdf5::read_dataset<std::int32_t>(file, "first").values;
    if (hdf5::exists(file, "rest_length"))
        header.rest_length = hdf5::read_dataset<double>(file, "rest_length").values;
    if (hdf5::exists(file, "kind"))
        header.kind = hdf5::read_dataset<std::int32_t>(file, "kind").values;
    if (hdf5::has_attribute(file, "kinds")) header.kinds = hdf5::read_text(file, "kinds");
    if (hdf5::exists(file, "wall_first")) {
        header.walls = hdf5::read_dataset<double>(file, "walls").values;
        header.wall_first = hdf5::read_dataset<std::int32_t>(file, "wall_first").values;
    }
    if (hdf5::exists(file, "origin"))
        header.origin = hdf5::read_dataset<double>(file, "origin").values;
    examine(header);
    return header;
}

Kind kind_of(hid_t file) {
    return hdf5::read_integer(file, "merged") == 0 ? Kind::index : Kind::whole;
}

void write_frame(hid_t file, const FramesHeader& header, const Frame& frame, std::int64_t number) {
    const hdf5::Id group = hdf5::create_group(file, group_name(number));
    hdf5::write_attribute(group, "time", frame.time);
    hdf5::write_attribute(group, "step", frame.step);
    const auto nodes = static_cast<hsize_t>(frame.nodes.size() / 2);
    const auto nx = static_cast<hsize_t>(header.nx);
    const auto ny = static_cast<hsize_t>(header.ny);
    const auto storage = header.compressed ? hdf5::Storage::compressed : hdf5::Storage::plain;
    const auto write = [&](const char* name, const std::vector<hsize_t>& shape, const auto& values,
                           const char* unit) {
        hdf5::write_dataset(group, name, shape, values, unit, storage);
    };
    write("nodes", {nodes, 2}, frame.nodes, "m");
    write("node_force", {nodes, 2}, frame.node_force, "N/m");
    write("node_velocity", {nodes, 2}, frame.node_velocity, "m/s");
    if (frame.velocity.empty()) return;
    write("velocity", {ny, nx, 2}, frame.velocity, "m/s");
    write("pressure", {ny, nx}, frame.pressure, "Pa");
    write("cytoplasm", {ny, nx}, frame.cytoplasm, "1");
}

Frame read_frame(hid_t file, const FramesHeader& header, std::int64_t number) {
    const hdf5::Id group = hdf5::open_group(file, group_name(number));
    const std::size_t sites =
        static_cast<std::size_t>(header.nx) * static_cast<std::size_t>(header.ny);
    Frame frame;
    frame.time = hdf5::read_double(group, "time");
    frame.step = hdf5::read_integer(group, "step");
    frame.nodes = read_nodes(group, "nodes", header);
    frame.node_force = read_nodes(group, "node_force", header);
    frame.node_velocity = read_nodes(group, "node_velocity", header);
    hdf5::expect(frame.node_force.size() == frame.nodes.size() &&
                     frame.node_velocity.size() == frame.nodes.size(),
                 "read forces and velocities of all", "nodes");
    if (!hdf5::exists(group, "velocity")) return frame;
    frame.velocity = read_values<float>(group, "velocity", 2 * sites);
    frame.pressure = read_values<float>(group, "pressure", sites);
    frame.cytoplasm = read_values<float>(group, "cytoplasm", sites);
    return frame;
}

FrameSummary read_summary(hid_t file, std::int64_t number) {
    const hdf5::Id group = hdf5::open_group(file, group_name(number));
    return {hdf5::read_double(group, "time"), hdf5::exists(group, "velocity")};
}

void write_times(hid_t file, const std::vector<FrameTime>& times) {
    std::vector<double> seconds;
    std::vector<std::int64_t> steps;
    for (const FrameTime& when : times) {
        seconds.push_back(when.time);
        steps.push_back(when.step);
    }
    hdf5::write_dataset(file, "time", {seconds.size()}, seconds, "s");
    hdf5::write_dataset(file, "step", steps);
}

std::vector<std::int64_t> numbers_in(hid_t file) {
    std::vector<std::int64_t> numbers;
    for (const std::string& name : hdf5::names_in(hdf5::open_group(file, "frames")))
        if (is_number(name)) numbers.push_back(std::stoll(name));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace tt::frames
