#include "io/disk.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* verb, const fs::path& path) {
    throw IoError(fmt::format("cannot {} '{}': {}", verb, path.string(), std::strerror(errno)));
}

}  // namespace

void sync_file(const fs::path& path) { OutputFile(path, OutputFile::Mode::append).sync(); }

void sync_entry(const fs::path& file) { move_into_place(file, file, Durability::power); }

PlacedFile::PlacedFile(fs::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail("open for writing", path_);
}

PlacedFile::~PlacedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void PlacedFile::write_at(std::uint64_t offset, const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = ::pwrite(descriptor_, next, count, static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write", path_);
        next += written;
        offset += static_cast<std::uint64_t>(written);
        count -= static_cast<std::size_t>(written);
    }
}

void PlacedFile::close() {
    const int descriptor = std::exchange(descriptor_, -1);
    if (descriptor >= 0 && ::close(descriptor) != 0) fail("close", path_);
}

}  // namespace tt
