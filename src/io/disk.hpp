#pragma once

#include <cstdint>
#include <filesystem>

namespace tt {

/// Return once the content of a file, or the directory entry of one, is on the disk.
void sync_file(const std::filesystem::path& path);
void sync_entry(const std::filesystem::path& file);

/// A new file that is written at any place. Every call is checked: IoError with the path.
class PlacedFile {
public:
    explicit PlacedFile(std::filesystem::path path);
    ~PlacedFile();
    PlacedFile(const PlacedFile&) = delete;
    PlacedFile& operator=(const PlacedFile&) = delete;

    void write_at(std::uint64_t offset, const void* bytes, std::size_t count);
    void close();
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace tt
