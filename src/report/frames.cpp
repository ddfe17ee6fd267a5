#include "report/frames.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/tell.hpp"

namespace tt {

namespace fs = std::filesystem;

std::optional<int> nearest_field(const FramesReader& frames, double time) {
    std::optional<int> nearest;
    const auto distance = [&](int k) { return std::abs(frames.time(k) - time); };
    for (int k = 0; k < frames.count(); ++k)
        if (frames.has_fields(k) && (!nearest || distance(k) < distance(*nearest))) nearest = k;
    return nearest;
}

std::vector<Vec2> wrapped_nodes(const FramesHeader& header, const Frame& frame) {
    std::vector<Vec2> nodes(frame.nodes.size() / 2);
    for (std::size_t c = 0; c + 1 < header.first.size(); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[c]);
        const auto end = static_cast<std::size_t>(header.first[c + 1]);
        double mean = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            mean += frame.nodes[2 * k] / static_cast<double>(end - begin);
        }
        const double shift = header.length * std::floor(mean / header.length);
        for (std::size_t k = begin; k < end; ++k) {
            nodes[k] = {frame.nodes[2 * k] - shift, frame.nodes[2 * k + 1]};
        }
    }
    return nodes;
}

std::vector<double> segment_lengths(const FramesHeader& header, const Frame& frame) {
    std::vector<double> lengths;
    for (std::size_t c = 0; c + 1 < header.first.size(); ++c) {
        const auto begin = static_cast<std::size_t>(header.first[c]);
        const auto end = static_cast<std::size_t>(header.first[c + 1]);
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t next = k + 1 < end ? k + 1 : begin;
            lengths.push_back(std::hypot(frame.nodes[2 * next] - frame.nodes[2 * k],
                                         frame.nodes[2 * next + 1] - frame.nodes[2 * k + 1]));
        }
    }
    return lengths;
}

std::vector<double> image_shifts(const FramesHeader& header, const std::vector<Vec2>& wrapped,
                                 int cell) {
    const auto begin = wrapped.begin() + header.first[static_cast<std::size_t>(cell)];
    const auto end = wrapped.begin() + header.first[static_cast<std::size_t>(cell) + 1];
    const auto [left, right] =
        std::minmax_element(begin, end, [](Vec2 a, Vec2 b) { return a.x < b.x; });
    std::vector<double> shifts{0.0};
    for (const double shift : {-header.length, header.length})
        if (right->x + shift > 0.0 && left->x + shift < header.length) shifts.push_back(shift);
    return shifts;
}

std::unique_ptr<const FramesReader> open_frames(const fs::path& directory) {
    if (!fs::is_directory(directory))
        throw IoError(directory.string() + ": no such results directory");
    const fs::path path = directory / "frames.h5";
    if (!fs::exists(path))
        throw IoError(path.string() +
                      ": does not exist; nothing to export (did the run write frames?)");
    auto frames = std::make_unique<const FramesReader>(path);
    for (const std::string& fault : frames->faults()) tell_user("tanktread: {}\n", fault);
    if (frames->count() == 0) throw IoError(path.string() + ": holds no frame that can be read");
    return frames;
}

}  // namespace tt
