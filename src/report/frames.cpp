#include "report/frames.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {
namespace {

/// `first` may be written with or without its end; the node count of the first frame settles it.
std::vector<int> cell_offsets(const Hdf5Input& file, std::int64_t nodes) {
    std::vector<int> first;
    if (file.has("first")) first = file.integers("first");
    if (nodes > 0 && (first.empty() || first.back() != nodes)) first.push_back(static_cast<int>(nodes));
    return first;
}

}  // namespace

FrameFile::FrameFile(const std::filesystem::path& path) : file_(path) {
    grid_.nx = static_cast<int>(file_.attribute("/", "nx"));
    grid_.ny = static_cast<int>(file_.attribute("/", "ny"));
    grid_.dx = file_.attribute("/", "dx");
    grid_.length = file_.attribute("/", "length");
    grid_.width = file_.attribute("/", "width");
    for (const std::string& name : file_.members("frames")) {
        const std::string group = "frames/" + name;
        if (!file_.has_attribute(group, "time") || !file_.has(group + "/nodes")) continue;
        names_.push_back(group);
        times_.push_back(file_.attribute(group, "time"));
    }
    grid_.first = cell_offsets(file_, names_.empty() ? 0 : file_.shape(names_.front() + "/nodes").front());
    if (file_.has("rest_length")) rest_length_ = file_.doubles("rest_length");
}

int FrameFile::nearest(double time) const {
    const auto further = [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
    return static_cast<int>(std::min_element(times_.begin(), times_.end(), further) - times_.begin());
}

std::vector<float> FrameFile::field(const std::string& name) const {
    if (!file_.has(name)) return {};
    std::vector<float> values = file_.floats(name);
    if (values.size() != static_cast<std::size_t>(grid_.nx) * grid_.ny)
        throw IoError(fmt::format("frames.h5: {} does not have ny × nx = {} × {} values", name, grid_.ny, grid_.nx));
    return values;
}

std::vector<Vec2> FrameFile::vectors(const std::string& name) const {
    if (!file_.has(name)) return {};
    const std::vector<double> flat = file_.doubles(name);
    if (flat.size() != 2 * static_cast<std::size_t>(grid_.node_count()))
        throw IoError(fmt::format("frames.h5: {} does not have {} × 2 values", name, grid_.node_count()));
    std::vector<Vec2> all(flat.size() / 2);
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = {flat[2 * k], flat[2 * k + 1]};
    return all;
}

std::vector<Vec2> FrameFile::read_nodes(int frame) const {
    return vectors(names_[static_cast<std::size_t>(frame)] + "/nodes");
}

Frame FrameFile::read(int frame) const {
    const std::string group = names_[static_cast<std::size_t>(frame)];
    Frame result;
    result.time = time(frame);
    if (file_.has_attribute(group, "step")) result.step = std::llround(file_.attribute(group, "step"));
    result.nodes = vectors(group + "/nodes");
    result.node_force = vectors(group + "/node_force");
    result.node_velocity = vectors(group + "/node_velocity");
    result.density = field(group + "/density");
    result.pressure = field(group + "/pressure");
    result.fraction = field(group + "/fraction");
    if (!file_.has(group + "/velocity")) return result;

    const std::vector<float> velocity = file_.floats(group + "/velocity");
    const std::size_t sites = static_cast<std::size_t>(grid_.nx) * grid_.ny;
    if (velocity.size() != 2 * sites) throw IoError(fmt::format("frames.h5: {}/velocity is not ny × nx × 2", group));
    result.velocity_x.resize(sites);
    result.velocity_y.resize(sites);
    for (std::size_t k = 0; k < sites; ++k) {
        result.velocity_x[k] = velocity[2 * k];
        result.velocity_y[k] = velocity[2 * k + 1];
    }
    return result;
}

void wrap_cell(std::vector<Vec2>& nodes, int begin, int end, double length) {
    double mean = 0.0;
    for (int k = begin; k < end; ++k) mean += nodes[static_cast<std::size_t>(k)].x / (end - begin);
    const double shift = length * std::floor(mean / length);
    for (int k = begin; k < end; ++k) nodes[static_cast<std::size_t>(k)].x -= shift;
}

}  // namespace tt
