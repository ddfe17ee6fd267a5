#include "report/frames.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/tell.hpp"
#include "base/words.hpp"

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
        Vec2 mean{};
        for (std::size_t k = begin; k < end; ++k)
            mean +=
                Vec2{frame.nodes[2 * k], frame.nodes[2 * k + 1]} / static_cast<double>(end - begin);
        const Vec2 shift{header.length * std::floor(mean.x / header.length),
                         header.width * std::floor(mean.y / header.width)};
        for (std::size_t k = begin; k < end; ++k)
            nodes[k] = Vec2{frame.nodes[2 * k], frame.nodes[2 * k + 1]} - shift;
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

std::vector<Vec2> image_shifts(const FramesHeader& header, const std::vector<Vec2>& wrapped,
                               int cell) {
    const auto begin = wrapped.begin() + header.first[static_cast<std::size_t>(cell)];
    const auto end = wrapped.begin() + header.first[static_cast<std::size_t>(cell) + 1];
    if (begin == end || !std::isfinite(begin->x)) return {};  // it has left
    const auto [left, right] =
        std::minmax_element(begin, end, [](Vec2 a, Vec2 b) { return a.x < b.x; });
    const auto [low, high] =
        std::minmax_element(begin, end, [](Vec2 a, Vec2 b) { return a.y < b.y; });
    std::vector<Vec2> shifts{{}};
    for (const double x : {0.0, -header.length, header.length})
        for (const double y : {0.0, -header.width, header.width}) {
            const bool reaches = right->x + x > 0.0 && left->x + x < header.length &&
                                 high->y + y > 0.0 && low->y + y < header.width;
            if (reaches && (x != 0.0 || y != 0.0)) shifts.push_back({x, y});
        }
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

std::vector<std::string> kind_names(const FramesHeader& header) {
    std::vector<std::string> names;
    for (const std::string_view name : split(header.kinds, ',')) names.emplace_back(name);
    if (names.empty()) names.emplace_back();
    return names;
}

}  // namespace tt
