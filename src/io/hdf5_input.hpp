#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tt {

/// An HDF5 file open for reading. Every failure is an IoError that names the file and the object.
/// The file may still be written to by a running simulation: no lock is taken.
class Hdf5Input {
public:
    explicit Hdf5Input(const std::filesystem::path& path);
    ~Hdf5Input();
    Hdf5Input(const Hdf5Input&) = delete;
    Hdf5Input& operator=(const Hdf5Input&) = delete;

    bool has(const std::string& object) const;
    bool has_attribute(const std::string& object, const std::string& name) const;
    double attribute(const std::string& object, const std::string& name) const;
    /// Names of what a group holds, in alphabetical order; empty if there is no such group.
    std::vector<std::string> members(const std::string& group) const;
    std::vector<std::int64_t> shape(const std::string& dataset) const;
    std::vector<double> doubles(const std::string& dataset) const;
    std::vector<float> floats(const std::string& dataset) const;
    std::vector<std::int32_t> integers(const std::string& dataset) const;

private:
    std::string path_;
    std::int64_t file_;
};

}  // namespace tt
