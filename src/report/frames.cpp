#include "report/frames.hpp"

#include <cmath>

namespace tt {

int nearest_frame(const FramesReader& frames, double time) {
    int nearest = 0;
    for (int k = 1; k < frames.count(); ++k)
        if (std::abs(frames.time(k) - time) < std::abs(frames.time(nearest) - time)) nearest = k;
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

}  // namespace tt
