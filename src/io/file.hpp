#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tt {

/// A file being written. Every call is checked: what goes wrong (disk full, size limit, no
/// permission) is an IoError that names the path and the cause.
class OutputFile {
public:
    enum class Mode : std::uint8_t { create, append };

    OutputFile(std::filesystem::path path, Mode mode);
    ~OutputFile();
    OutputFile(OutputFile&& other) noexcept;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    OutputFile& operator=(OutputFile&&) = delete;

    void write(const void* bytes, std::size_t count);
    /// At any place of a file that was created; in between, bytes are 0.
    void write_at(std::uint64_t offset, const void* bytes, std::size_t count);
    /// Appends all of `text` or, if that fails, leaves the file as it was and throws.
    void append(std::string_view text);
    /// Returns once the content is on the disk.
    void sync();
    /// Cuts the file to its first `size` bytes. Precondition: it has that many, else IoError.
    void cut(std::int64_t size);
    std::int64_t size() const;
    void close();
    const std::filesystem::path& path() const { return path_; }

private:
    [[noreturn]] void fail(const char* verb) const;

    std::filesystem::path path_;
    int descriptor_ = -1;
};

/// What a replaced file must survive: the end of this process, or a loss of power too.
enum class Durability : std::uint8_t { process, power };

/// Does what puts a whole file in its place and, where that fails, does it once more: a disk or a
/// network may refuse a single call. What fails twice is told.
template <class Action>
void with_second_try(Action action) {
    try {
        action();
    } catch (const IoError&) {
        action();
    }
}

/// Puts `bytes` in the place of `path` in one stroke: a reader sees the old content or the new, and
/// a failure (IoError) leaves the old.
void replace_file(const std::filesystem::path& path, std::string_view bytes, Durability durability);

/// Renames, checked; the directory entry is on the disk when it returns.
void move_into_place(const std::filesystem::path& from, const std::filesystem::path& to,
                     Durability durability);

/// Return once the content of a file, or the directory entry of one, is on the disk.
void sync_file(const std::filesystem::path& path);
void sync_directory(const std::filesystem::path& file);

/// Who wrote a file, and hence what it may be.
enum class Author : std::uint8_t {
    user,    ///< a text: at most 16 MiB, from a file or a pipe that does not keep us waiting
    program  ///< our own results: a file that fits into the memory of this machine
};

/// The whole file, and never more than its author may have written. IoError if it cannot be read,
/// is a directory or a device, is larger, or is a pipe that nobody has opened to write, or that
/// says nothing for ten seconds.
std::string read_file(const std::filesystem::path& path, Author author = Author::program);

/// Creates the directory and its parents. IoError if that fails.
void make_directory(const std::filesystem::path& path);

}  // namespace tt
