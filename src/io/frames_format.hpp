#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/frames.hpp"
#include "io/hdf5_driver.hpp"

/// How header and frames lie in an HDF5 file. For the writer and the reader of frames only.
namespace tt::frames {

/// frames/000007
std::string group_name(std::int64_t number);

/// The folder of frames that lie alone, beside frames.h5.
std::filesystem::path folder_of(const std::filesystem::path& frames_h5);
/// What frames.h5 was when a run that had ended was made longer.
std::filesystem::path merged_part(const std::filesystem::path& folder);

enum class Kind : std::int64_t { index = 0, whole = 1 };

/// Also makes the group `frames`.
void write_header(hid_t file, const FramesHeader& header, Kind kind);
/// The part of it that tells the cells, again where there are more.
void write_cells(hid_t file, const FramesHeader& header);
FramesHeader read_header(hid_t file);
Kind kind_of(hid_t file);

void write_frame(hid_t file, const FramesHeader& header, const Frame& frame, std::int64_t number);
/// IoError if the frame is not of the sizes that the header says.
Frame read_frame(hid_t file, const FramesHeader& header, std::int64_t number);
struct FrameSummary {
    double time = 0.0;
    bool has_fields = false;
};
FrameSummary read_summary(hid_t file, std::int64_t number);
/// Times [s] and steps of the frames of a file, in order, as datasets: for readers that see no
/// attributes.
void write_times(hid_t file, const std::vector<FrameTime>& times);

/// Numbers of the frames in a file, rising.
std::vector<std::int64_t> numbers_in(hid_t file);

/// A file of frames open for reading; its bytes are checked as they are read.
struct File {
    explicit File(const std::filesystem::path& path) : bytes(path), id(hdf5::open_sealed(bytes)) {}
    SealedFile bytes;
    hdf5::Id id;
};

}  // namespace tt::frames
