#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/file.hpp"

namespace tt {

/// A sealed file carries the checksums of its own bytes behind its content, where other readers of
/// its format do not look:
///
///     content | CRC-32 of each block of 4096 bytes of it | footer
///     footer: "tt-seal1" | bytes of content (u64) | CRC-32 of table and footer up to here (u32)
///
/// Numbers are little-endian. Damage is found block by block, so that the rest can be used.
std::string sealed(std::string content);

/// Puts the seal behind what a file holds.
void seal_file(const std::filesystem::path& path);

/// Reads a sealed file and hands out sound bytes only. A file without a seal can be read too; then
/// nothing is known of its bytes.
class SealedFile {
public:
    /// IoError if the file cannot be read or is empty.
    explicit SealedFile(std::filesystem::path path);
    ~SealedFile();
    SealedFile(const SealedFile&) = delete;
    SealedFile& operator=(const SealedFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    bool has_seal() const { return has_seal_; }
    /// Bytes of content.
    std::uint64_t size() const { return size_; }
    /// Copies content to `bytes`; false if a block of it is damaged or cannot be read.
    bool read(std::uint64_t offset, std::size_t count, char* bytes) const;
    /// Reads all of it: how many blocks are damaged.
    std::uint64_t damaged_blocks() const;
    std::uint64_t blocks() const;

private:
    bool read_raw(std::uint64_t offset, std::size_t count, char* bytes) const;
    void read_seal(std::uint64_t file_size);
    bool is_sound(std::uint64_t block, std::string_view bytes) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    bool has_seal_ = false;
    std::uint64_t size_ = 0;
    std::string table_;
};

}  // namespace tt
