#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/vec2.hpp"

namespace tt {

/// An array of a VTK file: values of `components` numbers a point, as raw bytes.
struct VtkArray {
    std::string name;
    std::string_view type;  ///< Float32, Float64, Int64, Int32
    int components = 1;
    std::string bytes;
};

/// The array of `values`, in the byte order of this machine (little-endian on all that we support).
template <class T>
VtkArray vtk_array(std::string name, int components, const std::vector<T>& values) {
    static_assert(std::is_arithmetic_v<T>);
    const std::string_view type = std::is_same_v<T, float>    ? "Float32"
                                  : std::is_same_v<T, double> ? "Float64"
                                  : sizeof(T) == 8            ? "Int64"
                                                              : "Int32";
    VtkArray array{std::move(name), type, components, std::string(values.size() * sizeof(T), '\0')};
    if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
    return array;
}

/// Image data (.vti): point (i, j) at origin + spacing · (i, j), i running fastest; raw appended
/// data with 64-bit sizes.
void write_vti(const std::filesystem::path& path, int nx, int ny, Vec2 origin, double spacing,
               const std::vector<VtkArray>& point_data);

/// Lines or polygons, each through a list of points.
struct VtkElements {
    std::vector<std::int64_t> connectivity;  ///< the lists, one after the other
    std::vector<std::int64_t> offsets;       ///< where each ends

    void add(std::span<const std::int64_t> list) {
        connectivity.insert(connectivity.end(), list.begin(), list.end());
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
};

/// Lines and polygons (.vtp). `element_data` has a value for each line, then for each polygon.
void write_vtp(const std::filesystem::path& path, std::span<const Vec2> points,
               const VtkElements& lines, const VtkElements& polygons,
               const std::vector<VtkArray>& point_data, const std::vector<VtkArray>& element_data);

/// A file of a time series.
struct PvdEntry {
    double time;
    std::string file;  ///< relative to the .pvd
};
void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

}  // namespace tt
