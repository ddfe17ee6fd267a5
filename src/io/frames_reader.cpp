#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/undefined.hpp"
#include "io/frames_format.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// merged.h5 first, then the frames that lie alone: those written anew come last.
std::vector<fs::path> parts_in(const fs::path& folder) {
    std::vector<fs::path> parts;
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent))
        if (entry.path().extension() == ".h5" && entry.path() != frames::merged_part(folder))
            parts.push_back(entry.path());
    std::sort(parts.begin(), parts.end());
    if (fs::exists(frames::merged_part(folder)))
        parts.insert(parts.begin(), frames::merged_part(folder));
    return parts;
}

std::string numbers_text(const std::vector<std::int64_t>& numbers) {
    std::string text = numbers.size() == 1 ? "frame " : "frames ";
    for (std::size_t k = 0; k < numbers.size(); ++k)
        text += fmt::format("{}{}", k == 0 ? "" : ", ", numbers[k]);
    return text;
}

}  // namespace

FramesReader::~FramesReader() = default;

FramesReader::FramesReader(const fs::path& path) {
    const fs::path folder = frames::folder_of(path);
    bool whole = !fs::exists(folder);
    std::optional<std::vector<std::int64_t>> listed;
    try {
        const frames::File file(path);
        header_ = frames::read_header(file.id);
        whole = frames::kind_of(file.id) == frames::Kind::whole;
        if (!whole) {
            listed = frames::numbers_in(file.id);
            note_state(file.bytes, file.bytes.damaged_blocks() == 0, {});
        }
    } catch (const std::exception& error) {
        if (!whole)
            faults_.push_back(fmt::format("{} is damaged: {}", path.string(), error.what()));
    }
    if (whole) {
        add_file(path);
    } else {
        add_parts(folder, listed);
    }
    if (header_.nx == 0)
        throw IoError(faults_.empty() ? path.string() + " holds no frame" : faults_.front());
}

void FramesReader::add_parts(const fs::path& folder,
                             const std::optional<std::vector<std::int64_t>>& listed) {
    std::map<std::int64_t, Entry> by_number;
    for (const fs::path& part : parts_in(folder)) {
        entries_.clear();
        add_file(part);
        for (Entry& entry : entries_) by_number[entry.number] = std::move(entry);
    }
    entries_.clear();
    std::vector<std::int64_t> missing;
    if (listed) {
        std::map<std::int64_t, Entry> counted;  // merged.h5 may hold frames of a later time
        for (const std::int64_t number : *listed) {
            if (auto found = by_number.extract(number)) {
                counted.insert(std::move(found));
            } else {
                missing.push_back(number);
            }
        }
        by_number = std::move(counted);
    }
    for (auto& [number, entry] : by_number) entries_.push_back(std::move(entry));
    if (!missing.empty())
        faults_.push_back(fmt::format("{} lacks {}", folder.string(), numbers_text(missing)));
}

/// Adds the sound frames of one file, and in words what is not sound.
void FramesReader::add_file(const fs::path& path) {
    try {
        add_frames(path);
    } catch (const std::exception& error) {  // bad_alloc too, of a file without a seal
        faults_.push_back(
            fmt::format("{} is damaged and left out: {}", path.string(), error.what()));
    }
}

void FramesReader::add_frames(const fs::path& path) {
    const frames::File file(path);
    FramesHeader header = frames::read_header(file.id);
    const bool more_cells = header.first.size() > header_.first.size();  // than had come before
    if (header_.nx == 0 || more_cells) header_ = std::move(header);
    const bool sound = file.bytes.damaged_blocks() == 0;
    std::vector<std::int64_t> damaged;
    for (const std::int64_t number : frames::numbers_in(file.id)) {
        try {
            if (!sound || !file.bytes.has_seal()) frames::read_frame(file.id, header_, number);
            const auto [time, has_fields] = frames::read_summary(file.id, number);
            entries_.push_back({number, time, has_fields, path});
        } catch (const std::exception&) {
            damaged.push_back(number);
        }
    }
    if (damaged.empty()) sound_files_.push_back(path);
    note_state(file.bytes, sound, damaged);
}

/// What is not sound of a file that can be read, in words.
void FramesReader::note_state(const SealedFile& file, bool sound,
                              const std::vector<std::int64_t>& damaged) {
    const std::string path = file.path().string();
    if (!damaged.empty())
        faults_.push_back(fmt::format("{} is damaged: {} left out", path, numbers_text(damaged)));
    else if (!sound)
        faults_.push_back(fmt::format("{} is damaged, where no frame lies", path));
    if (!file.has_seal())
        faults_.push_back(
            fmt::format("{} has no checksums: whether what it holds is sound is not known", path));
}

Frame FramesReader::frame(int k) const {
    Frame frame = stored(k);
    const auto all = 2 * static_cast<std::size_t>(header_.first.back());
    for (auto* per_node : {&frame.nodes, &frame.node_force, &frame.node_velocity})
        per_node->resize(all, undefined);
    return frame;
}

Frame FramesReader::stored(int k) const {
    if (!opened_ || opened_->bytes.path() != entry(k).file)
        opened_ = std::make_unique<frames::File>(entry(k).file);
    return frames::read_frame(opened_->id, header_, entry(k).number);
}

}  // namespace tt
