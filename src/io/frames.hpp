#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/hdf5.hpp"

namespace tt {

/// What all frames of a run share, SI. Root attributes of frames.h5, and `first` as a dataset.
struct FramesHeader {
    std::string name;
    double dx = 0.0;                   ///< site spacing [m]
    double dt = 0.0;                   ///< time step [s]
    double length = 0.0, width = 0.0;  ///< of the box [m]; attribute `lengths`
    int nx = 0, ny = 0;
    std::vector<std::int32_t> first{0};  ///< nodes of cell c are first[c] … first[c+1]
};

/// One picture of the flow, SI. Group /frames/000000 … of frames.h5 with attributes `time` and
/// `step`.
struct Frame {
    double time = 0.0;
    std::int64_t step = 0;
    std::vector<double> nodes;          ///< x, y per node [m], unwrapped; shape (N, 2)
    std::vector<double> node_force;     ///< per unit depth [N/m]; (N, 2)
    std::vector<double> node_velocity;  ///< [m/s]; (N, 2)
    std::vector<float> velocity;        ///< at each site [m/s]; (ny, nx, 2), row 0 at the bottom
    std::vector<float> pressure;        ///< above its value at rest [Pa]; (ny, nx)
    std::vector<float> cytoplasm;       ///< fraction of cytoplasm, 0 … 1; (ny, nx)
};

/// Writes frames.h5 so that neither kill -9 nor a full disk can harm a frame already written, and
/// so that it can be read while the run goes on: each frame is a whole HDF5 file of its own in the
/// folder frames/, put there in one stroke, and frames.h5 is a small index of external links,
/// replaced in one stroke. `merge` makes one plain file of all.
class FramesWriter {
public:
    /// Continues with frame `count`: later ones, left by a run that went on after its last
    /// checkpoint, are removed.
    FramesWriter(std::filesystem::path directory, FramesHeader header, std::int64_t count);

    void write(const Frame& frame);
    std::int64_t count() const { return count_; }
    /// Turns index and folder into one file. IoError if there is no room; then everything stays as
    /// it was.
    void merge();

private:
    std::filesystem::path part(std::int64_t number) const;
    void add_to_index(std::int64_t number);
    void write_index() const;

    std::filesystem::path directory_;  ///< of the results
    FramesHeader header_;
    std::int64_t count_ = 0;
    std::int64_t merged_ = 0;                    ///< frames that lie in frames/merged.h5
    hdf5::Id index_ = hdf5::create_in_memory();  ///< frames.h5 until merged: a link to each frame
};

/// Reads frames.h5, indexed or merged.
class FramesReader {
public:
    explicit FramesReader(const std::filesystem::path& path);
    ~FramesReader();
    FramesReader(const FramesReader&) = delete;
    FramesReader& operator=(const FramesReader&) = delete;

    const FramesHeader& header() const { return header_; }
    int count() const { return count_; }
    /// Time [s] of frame `number`.
    double time(int number) const;
    Frame frame(int number) const;

private:
    std::int64_t file_ = -1;
    FramesHeader header_;
    int count_ = 0;
};

}  // namespace tt
