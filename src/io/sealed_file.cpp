#include "io/sealed_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/crc32.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t block_size = 4096;
constexpr std::uint64_t stretch = 256 * block_size;  ///< read at a time
constexpr std::string_view magic = "tt-seal1";
constexpr std::size_t footer_size = magic.size() + sizeof(std::uint64_t) + sizeof(std::uint32_t);

std::uint64_t blocks_in(std::uint64_t size) { return (size + block_size - 1) / block_size; }

template <class T>
void append_number(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void append_checksums(std::string& table, std::string_view content) {
    for (std::size_t at = 0; at < content.size(); at += block_size)
        append_number(table, crc32(content.substr(at, block_size)));
}

/// Turns the table of checksums into the whole seal.
void append_footer(std::string& table, std::uint64_t content_size) {
    table += magic;
    append_number(table, content_size);
    append_number(table, crc32(table));
}

}  // namespace

std::string sealed(std::string content) {
    std::string seal;
    append_checksums(seal, content);
    append_footer(seal, content.size());
    return content += seal;
}

void seal_file(const fs::path& path) {
    std::string seal;
    std::uint64_t size = 0;
    {
        const SealedFile content(path);
        size = content.size();
        std::string bytes;
        for (std::uint64_t at = 0; at < size; at += bytes.size()) {
            bytes.resize(std::min(stretch, size - at));
            if (!content.read(at, bytes.size(), bytes.data()))
                throw IoError(fmt::format("cannot read '{}' back", path.string()));
            append_checksums(seal, bytes);
        }
    }
    append_footer(seal, size);
    OutputFile file(path, OutputFile::Mode::append);
    file.write(seal.data(), seal.size());
    file.sync();
    file.close();
}

SealedFile::SealedFile(fs::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
    const off_t end = descriptor_ < 0 ? -1 : ::lseek(descriptor_, 0, SEEK_END);
    if (end > 0) {
        read_seal(static_cast<std::uint64_t>(end));
        return;
    }
    const std::string cause = end == 0 ? "it is empty" : std::strerror(errno);
    if (descriptor_ >= 0) ::close(descriptor_);
    throw IoError(fmt::format("cannot read '{}': {}", path_.string(), cause));
}

SealedFile::~SealedFile() { ::close(descriptor_); }

void SealedFile::read_seal(std::uint64_t file_size) {
    size_ = file_size;
    std::string footer(footer_size, '\0');
    if (file_size < footer_size || !read_raw(file_size - footer_size, footer_size, footer.data()))
        return;
    const auto content = number_at<std::uint64_t>(footer, magic.size());
    if (!footer.starts_with(magic) || content > file_size) return;
    const std::uint64_t table = blocks_in(content) * sizeof(std::uint32_t);
    if (file_size - content != table + footer_size) return;
    table_.resize(table);
    if (!read_raw(content, table, table_.data())) return;
    const auto stated = number_at<std::uint32_t>(footer, footer_size - sizeof(std::uint32_t));
    footer.resize(footer_size - sizeof stated);
    if (crc32(footer, crc32(table_)) != stated) return;
    size_ = content;
    has_seal_ = true;
}

bool SealedFile::read_raw(std::uint64_t offset, std::size_t count, char* bytes) const {
    while (count > 0) {
        const ssize_t got = ::pread(descriptor_, bytes, count, static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got;
        offset += static_cast<std::uint64_t>(got);
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

bool SealedFile::is_sound(std::uint64_t block, std::string_view bytes) const {
    return !has_seal_ ||
           crc32(bytes) == number_at<std::uint32_t>(table_, block * sizeof(std::uint32_t));
}

bool SealedFile::read(std::uint64_t offset, std::size_t count, char* bytes) const {
    if (offset > size_ || count > size_ - offset) return false;
    if (!has_seal_) return read_raw(offset, count, bytes);
    std::string whole;  // blocks, of which `count` bytes from `offset` on are wanted
    for (const std::uint64_t end = offset + count; offset < end;) {
        const std::uint64_t first = offset - offset % block_size;
        const std::uint64_t last = std::min({first + stretch, size_, blocks_in(end) * block_size});
        whole.resize(last - first);
        if (!read_raw(first, whole.size(), whole.data())) return false;
        for (std::uint64_t at = first; at < last; at += block_size) {
            const auto block = std::string_view(whole).substr(at - first, block_size);
            if (!is_sound(at / block_size, block)) return false;
        }
        const std::uint64_t wanted = std::min(end, last) - offset;
        std::memcpy(bytes, whole.data() + (offset - first), wanted);
        bytes += wanted;
        offset += wanted;
    }
    return true;
}

std::uint64_t SealedFile::blocks() const { return blocks_in(size_); }

std::uint64_t SealedFile::damaged_blocks() const {
    std::uint64_t damaged = 0;
    std::string bytes;
    for (std::uint64_t at = 0; has_seal_ && at < size_; at += stretch) {
        bytes.resize(std::min(stretch, size_ - at));
        if (read(at, bytes.size(), bytes.data())) continue;
        for (std::uint64_t b = 0; b < bytes.size(); b += block_size) {
            const std::uint64_t length = std::min(block_size, bytes.size() - b);
            damaged += read(at + b, length, bytes.data()) ? 0 : 1;
        }
    }
    return damaged;
}

}  // namespace tt
