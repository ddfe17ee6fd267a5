#include "io/frames.hpp"

#include <array>
#include <system_error>

#include <fmt/format.h>

#include "io/file.hpp"
#include "io/hdf5.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

std::string group_name(std::int64_t number) { return fmt::format("frames/{:06d}", number); }

void write_header(hid_t file, const FramesHeader& header) {
    hdf5::write_attribute(file, "name", header.name);
    hdf5::write_attribute(file, "dx", header.dx);
    hdf5::write_attribute(file, "dt", header.dt);
    hdf5::write_attribute(file, "lengths", std::array{header.length, header.width});
    hdf5::write_attribute(file, "nx", static_cast<std::int64_t>(header.nx));
    hdf5::write_attribute(file, "ny", static_cast<std::int64_t>(header.ny));
    hdf5::write_dataset(file, "first", header.first);
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
    return header;
}

void write_frame(hid_t file, const FramesHeader& header, const Frame& frame, std::int64_t number) {
    const hdf5::Id group = hdf5::create_group(file, group_name(number));
    hdf5::write_attribute(group, "time", frame.time);
    hdf5::write_attribute(group, "step", frame.step);
    const auto nodes = static_cast<hsize_t>(header.first.back());
    const auto nx = static_cast<hsize_t>(header.nx);
    const auto ny = static_cast<hsize_t>(header.ny);
    hdf5::write_dataset(group, "nodes", {nodes, 2}, frame.nodes, "m");
    hdf5::write_dataset(group, "node_force", {nodes, 2}, frame.node_force, "N/m");
    hdf5::write_dataset(group, "node_velocity", {nodes, 2}, frame.node_velocity, "m/s");
    hdf5::write_dataset(group, "velocity", {ny, nx, 2}, frame.velocity, "m/s");
    hdf5::write_dataset(group, "pressure", {ny, nx}, frame.pressure, "Pa");
    hdf5::write_dataset(group, "cytoplasm", {ny, nx}, frame.cytoplasm, "1");
}

int count_frames(hid_t file) {
    H5G_info_t info{};
    const hdf5::Id group = hdf5::open_group(file, "frames");
    hdf5::expect(H5Gget_info(group, &info) >= 0, "count", "frames");
    return static_cast<int>(info.nlinks);
}

/// Frames in `path`; 0 if it is not there.
std::int64_t frames_in(const fs::path& path) {
    if (!fs::exists(path)) return 0;
    return count_frames(hdf5::open_file(path));
}

/// A merged file says so; an index holds links only.
bool is_merged(const fs::path& path) {
    const hdf5::Id file = hdf5::open_file(path);
    return hdf5::read_integer(file, "merged") != 0;
}

}  // namespace

FramesWriter::FramesWriter(fs::path directory, FramesHeader header, std::int64_t count)
    : directory_(std::move(directory)), header_(std::move(header)), count_(count) {
    const fs::path folder = directory_ / "frames";
    const fs::path index = directory_ / "frames.h5";
    const fs::path merged = folder / "merged.h5";
    make_directory(folder);
    if (fs::exists(index) && is_merged(index)) move_into_place(index, merged, Durability::power);
    merged_ = frames_in(merged);
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string stem = entry.path().stem().string();
        const bool numbered =
            !stem.empty() && stem.find_first_not_of("0123456789") == std::string::npos;
        std::error_code ignored;
        if (numbered && std::stoll(stem) >= count_) fs::remove(entry.path(), ignored);
    }
    write_header(index_, header_);
    hdf5::write_attribute(index_, "merged", std::int64_t{0});
    hdf5::create_group(index_, "frames");
    for (std::int64_t number = 0; number < count_; ++number) add_to_index(number);
    write_index();
}

fs::path FramesWriter::part(std::int64_t number) const {
    return directory_ / (group_name(number) + ".h5");
}

void FramesWriter::write(const Frame& frame) {
    const hdf5::Id file = hdf5::create_in_memory();
    write_header(file, header_);
    hdf5::create_group(file, "frames");
    write_frame(file, header_, frame, count_);
    replace_file(part(count_), hdf5::image(file), Durability::process);
    add_to_index(count_++);
    write_index();
}

void FramesWriter::add_to_index(std::int64_t number) {
    const std::string name = group_name(number);
    // A frame of an earlier, merged part of the run, unless it has been written anew since.
    const bool alone = number >= merged_ || fs::exists(part(number));
    hdf5::link_external(index_, name, alone ? name + ".h5" : "frames/merged.h5", "/" + name);
}

void FramesWriter::write_index() const {
    replace_file(directory_ / "frames.h5", hdf5::image(index_), Durability::process);
}

void FramesWriter::merge() {
    const fs::path index = directory_ / "frames.h5";
    const fs::path temporary = directory_ / "frames.h5.tmp";
    std::uint64_t bytes = 1 << 20;
    for (const auto& entry : fs::directory_iterator(directory_ / "frames"))
        bytes += entry.file_size();
    expect_room(temporary, bytes);
    try {
        const hdf5::Id from = hdf5::open_file(index);
        hdf5::Id to = hdf5::create_file(temporary);
        write_header(to, header_);
        hdf5::write_attribute(to, "merged", std::int64_t{1});
        hdf5::create_group(to, "frames");
        for (std::int64_t number = 0; number < count_; ++number)
            hdf5::copy(from, to, group_name(number));
        hdf5::expect(H5Fflush(to, H5F_SCOPE_GLOBAL) >= 0, "flush", temporary.string());
        to.reset();
        OutputFile(temporary, OutputFile::Mode::append).sync();
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
    move_into_place(temporary, index, Durability::power);
    std::error_code ignored;
    fs::remove_all(directory_ / "frames", ignored);
}

FramesReader::FramesReader(const fs::path& path) {
    hdf5::Id file = hdf5::open_file(path);
    header_ = read_header(file);
    count_ = count_frames(file);
    file_ = H5Freopen(file);
    hdf5::expect(file_ >= 0, "reopen", path.string());
}

FramesReader::~FramesReader() {
    if (file_ >= 0) H5Fclose(file_);
}

double FramesReader::time(int number) const {
    return hdf5::read_double(hdf5::open_group(file_, group_name(number)), "time");
}

Frame FramesReader::frame(int number) const {
    const hdf5::Id group = hdf5::open_group(file_, group_name(number));
    Frame frame;
    frame.time = hdf5::read_double(group, "time");
    frame.step = hdf5::read_integer(group, "step");
    frame.nodes = hdf5::read_dataset<double>(group, "nodes").values;
    frame.node_force = hdf5::read_dataset<double>(group, "node_force").values;
    frame.node_velocity = hdf5::read_dataset<double>(group, "node_velocity").values;
    frame.velocity = hdf5::read_dataset<float>(group, "velocity").values;
    frame.pressure = hdf5::read_dataset<float>(group, "pressure").values;
    frame.cytoplasm = hdf5::read_dataset<float>(group, "cytoplasm").values;
    return frame;
}

}  // namespace tt
