#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/hdf5.hpp"
#include "io/sealed_file.hpp"

namespace tt {
namespace frames {
struct File;
}

/// What all frames of a run share, SI. Root attributes of frames.h5, and `first` as a dataset.
struct FramesHeader {
    std::string name;
    double dx = 0.0;                   ///< site spacing [m]
    double dt = 0.0;                   ///< time step [s]
    double length = 0.0, width = 0.0;  ///< of the box [m]; attribute `lengths`
    int nx = 0, ny = 0;
    std::vector<std::int32_t> first{0};  ///< nodes of cell c are first[c] … first[c+1]
    /// Of the segment from each node to its successor, without tension [m]; dataset. Empty in files
    /// of other writers.
    std::vector<double> rest_length;
    std::vector<std::int32_t> kind;  ///< of each cell; dataset. Empty in files of other writers
    std::string kinds;               ///< names of the kinds, parted by commas; attribute
    /// Walls that are not those of the box: x, y of their corners [m], wall_first[w] … wall_first[w
    /// + 1] of loop w; solid is what an odd number of loops goes around. Datasets; absent without.
    std::vector<double> walls;
    std::vector<std::int32_t> wall_first;
    /// x, y [m] of the corner of the box in the coordinates of the drawing; dataset, absent where
    /// they are the same.
    std::vector<double> origin;
    bool compressed = false;  ///< of frames to be written
};

/// One picture of the flow, SI. Group /frames/000000 … of frames.h5 with attributes `time` and
/// `step`.
struct Frame {
    double time = 0.0;
    std::int64_t step = 0;
    /// x, y per node [m], unwrapped; shape (N, 2), N the nodes of all cells that had come by then.
    /// NaN of cells that have left.
    std::vector<double> nodes;
    std::vector<double> node_force;     ///< per unit depth [N/m]; (N, 2)
    std::vector<double> node_velocity;  ///< [m/s]; (N, 2)
    // The fields, all of them or none.
    std::vector<float> velocity;   ///< at each site [m/s]; (ny, nx, 2), row 0 at the bottom
    std::vector<float> pressure;   ///< above its value at rest [Pa]; (ny, nx)
    std::vector<float> cytoplasm;  ///< fraction of cytoplasm, 0 … 1; (ny, nx)
};

/// When a frame was taken.
struct FrameTime {
    double time = 0.0;  ///< [s]
    std::int64_t step = 0;
};

/// Reads frames.h5, index or merged. Frames that are damaged are left out and told.
class FramesReader {
public:
    /// Reads every byte once. IoError if nothing at all can be read.
    explicit FramesReader(const std::filesystem::path& path);
    ~FramesReader();
    FramesReader(const FramesReader&) = delete;
    FramesReader& operator=(const FramesReader&) = delete;

    const FramesHeader& header() const { return header_; }
    /// Of the frames that are sound; they are counted from 0 below.
    int count() const { return static_cast<int>(entries_.size()); }
    /// The number of frame k in the file: larger than k after one that was left out.
    std::int64_t number(int k) const { return entry(k).number; }
    /// Time [s] of frame k.
    double time(int k) const { return entry(k).time; }
    bool has_fields(int k) const { return entry(k).has_fields; }
    Frame frame(int k) const;
    /// The same without a place for cells that came later.
    Frame stored(int k) const;
    /// What is damaged, a sentence each; empty if all is sound.
    const std::vector<std::string>& faults() const { return faults_; }
    /// The files that hold frames, all of them sound.
    const std::vector<std::filesystem::path>& sound_files() const { return sound_files_; }

private:
    struct Entry {
        std::int64_t number = 0;
        double time = 0.0;
        bool has_fields = false;
        std::filesystem::path file;
    };

    const Entry& entry(int k) const { return entries_.at(static_cast<std::size_t>(k)); }
    /// `listed`: the frames of the index; nothing if it cannot be read.
    void add_parts(const std::filesystem::path& folder,
                   const std::optional<std::vector<std::int64_t>>& listed);
    void add_file(const std::filesystem::path& path);
    void add_frames(const std::filesystem::path& path);
    void note_state(const SealedFile& file, bool sound, const std::vector<std::int64_t>& damaged);

    FramesHeader header_;
    std::vector<Entry> entries_;
    std::vector<std::string> faults_;
    std::vector<std::filesystem::path> sound_files_;
    mutable std::unique_ptr<frames::File> opened_;  ///< the file read last
};

/// Writes frames.h5 so that neither kill -9 nor a full disk can harm a frame already written, and
/// so that it can be read while the run goes on: each frame is a whole, sealed HDF5 file of its own
/// in the folder frames/, put there in one stroke, and frames.h5 is a small index of external
/// links, replaced in one stroke. `merge` makes one plain file of all.
class FramesWriter {
public:
    /// Continues after the frames `kept`: later ones, left by a run that went on after its last
    /// checkpoint, are removed.
    FramesWriter(std::filesystem::path directory, FramesHeader header, std::vector<FrameTime> kept);

    /// More cells than before are in the frames from now on, those of `now`; those there were stay
    /// the first ones.
    void add_cells(const FramesHeader& now);
    void write(const Frame& frame);
    const std::vector<FrameTime>& times() const { return times_; }
    /// Returns once the frames written are on the disk.
    void sync();
    /// Turns index and folder into one file, without what is damaged; what is, in words. IoError if
    /// it cannot be written; then everything stays as it was.
    std::vector<std::string> merge();

private:
    std::filesystem::path part(std::int64_t number) const;
    std::filesystem::path index() const { return directory_ / "frames.h5"; }
    void keep_merged() const;
    void remove_after(std::int64_t count) const;
    void add_to_index(std::int64_t number);
    void write_index() const;
    void write_whole(const FramesReader& from, const std::filesystem::path& path) const;

    std::filesystem::path directory_;  ///< of the results
    FramesHeader header_;
    std::vector<FrameTime> times_;
    std::vector<std::filesystem::path> unsynced_;
    hdf5::Id index_ = hdf5::create_in_memory();  ///< frames.h5 until merged: a link to each frame
};

}  // namespace tt
