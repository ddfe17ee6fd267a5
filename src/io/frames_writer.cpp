#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "io/file.hpp"
#include "io/frames_format.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

bool holds_frames(const fs::path& folder) {
    return std::any_of(fs::directory_iterator(folder), {},
                       [](const auto& entry) { return entry.path().extension() == ".h5"; });
}

}  // namespace

FramesWriter::FramesWriter(fs::path directory, FramesHeader header, std::vector<FrameTime> kept)
    : directory_(std::move(directory)), header_(std::move(header)) {
    make_directory(frames::folder_of(index()));
    keep_merged();
    remove_after(static_cast<std::int64_t>(kept.size()));
    frames::write_header(index_, header_, frames::Kind::index);
    hdf5::create_growing(index_, "time", H5T_NATIVE_DOUBLE, "s");
    hdf5::create_growing(index_, "step", H5T_NATIVE_INT64, "");
    for (const FrameTime& when : kept) {
        times_.push_back(when);
        add_to_index(static_cast<std::int64_t>(times_.size()) - 1);
    }
    write_index();
}

fs::path FramesWriter::part(std::int64_t number) const {
    return directory_ / (frames::group_name(number) + ".h5");
}

/// frames.h5 of a run that had ended becomes a part. One that cannot be read was an index if there
/// are frames without it.
void FramesWriter::keep_merged() const {
    if (!fs::exists(index())) return;
    const fs::path folder = frames::folder_of(index());
    bool whole = !holds_frames(folder);
    try {
        whole = frames::kind_of(frames::File(index()).id) == frames::Kind::whole;
    } catch (const IoError&) {  // damaged: told by whoever reads it
    }
    if (whole) move_into_place(index(), frames::merged_part(folder), Durability::power);
}

void FramesWriter::remove_after(std::int64_t count) const {
    for (const auto& entry : fs::directory_iterator(frames::folder_of(index()))) {
        const std::string stem = entry.path().stem().string();
        const bool numbered = !stem.empty() && stem.size() < 16 &&
                              stem.find_first_not_of("0123456789") == std::string::npos;
        std::error_code ignored;
        if (numbered && std::stoll(stem) >= count) fs::remove(entry.path(), ignored);
    }
}

void FramesWriter::add_cells(const FramesHeader& now) {
    header_.first = now.first;
    header_.rest_length = now.rest_length;
    header_.kind = now.kind;
    frames::write_cells(index_, header_);
}

void FramesWriter::write(const Frame& frame) {
    const auto number = static_cast<std::int64_t>(times_.size());
    const hdf5::Id file = hdf5::create_in_memory();
    frames::write_header(file, header_, frames::Kind::whole);
    frames::write_times(file, {{frame.time, frame.step}});
    frames::write_frame(file, header_, frame, number);
    replace_file(part(number), sealed(hdf5::image(file)), Durability::process);
    unsynced_.push_back(part(number));
    times_.push_back({frame.time, frame.step});
    add_to_index(number);
    write_index();
}

void FramesWriter::add_to_index(std::int64_t number) {
    const std::string name = frames::group_name(number);
    // A frame of an earlier, merged part of the run, unless it has been written anew since.
    const bool alone = fs::exists(part(number));
    const fs::path merged = frames::merged_part("frames");
    const bool in_merged = !alone && fs::exists(directory_ / merged);
    hdf5::link_external(index_, name, in_merged ? merged.string() : name + ".h5", "/" + name);
    const FrameTime& when = times_[static_cast<std::size_t>(number)];
    hdf5::append(index_, "time", when.time);
    hdf5::append(index_, "step", when.step);
}

void FramesWriter::write_index() const {
    replace_file(index(), sealed(hdf5::image(index_)), Durability::process);
}

void FramesWriter::sync() {
    if (unsynced_.empty()) return;
    for (const fs::path& path : unsynced_) sync_file(path);
    sync_directory(unsynced_.back());
    sync_file(index());
    sync_directory(index());
    unsynced_.clear();
}

std::vector<std::string> FramesWriter::merge() {
    const fs::path temporary = directory_ / "frames.h5.tmp";
    std::optional<FramesReader> parts(std::in_place, index());
    // What cannot be read may be damaged, or the disk has failed but once.
    if (parts->count() < static_cast<int>(times_.size())) parts.emplace(index());
    const FramesReader& from = *parts;
    std::error_code ignored;
    try {
        write_whole(from, temporary);
    } catch (...) {
        fs::remove(temporary, ignored);
        throw;
    }
    move_into_place(temporary, index(), Durability::power);
    // What is damaged stays: somebody may yet read it.
    for (const fs::path& path : from.sound_files()) fs::remove(path, ignored);
    fs::remove(frames::folder_of(index()), ignored);
    return from.faults();
}

void FramesWriter::write_whole(const FramesReader& from, const fs::path& path) const {
    hdf5::GuardedFile to(path);
    frames::write_header(to.id(), header_, frames::Kind::whole);
    std::vector<FrameTime> times;
    for (int k = 0; k < from.count(); ++k) {
        const Frame frame = from.stored(k);
        frames::write_frame(to.id(), header_, frame, from.number(k));
        times.push_back({frame.time, frame.step});
        to.expect_sound();
    }
    frames::write_times(to.id(), times);
    to.close();
    seal_file(path);
}

}  // namespace tt
