#include "io/archive.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Names the format and its version; the last byte pair tells the order of bytes in a number.
constexpr char magic[16] = {'t', 'a', 'n', 'k',  't',  'r',  'e',  'a',
                            'd', ' ', '1', '\n', 0x04, 0x03, 0x02, 0x01};

std::size_t element_size(char code) {
    switch (code) {
        case 'd':
            return sizeof(double);
        case 'l':
            return sizeof(std::int64_t);
        case 'i':
            return sizeof(std::int32_t);
        case 'c':
            return 1;
        default:
            return 0;
    }
}

fs::path with_suffix(fs::path path, const char* suffix) { return path += suffix; }

/// Gives what stands at `path` a second name, so that `path` itself is never absent.
void keep(const fs::path& path, const fs::path& previous, Durability durability) {
    std::error_code code;
    if (!fs::exists(path, code)) return;
    const fs::path link = with_suffix(previous, ".tmp");
    fs::remove(link, code);
    fs::create_hard_link(path, link, code);
    // A file system without hard links: for a moment only `previous` exists, which readers fall
    // back to.
    const bool linked = !code;
    move_into_place(linked ? link : path, previous, durability);
    // Where a kill came before, both are names of one file, and a renaming did nothing (POSIX).
    if (linked) fs::remove(link, code);
}

}  // namespace

void ArchiveOutput::put_bytes(std::string_view name, char code, std::uint64_t count,
                              const void* bytes, std::size_t size) {
    const auto length = static_cast<std::uint32_t>(name.size());
    std::string head(reinterpret_cast<const char*>(&length), sizeof length);
    head.append(name).append(1, code);
    head.append(reinterpret_cast<const char*>(&count), sizeof count);
    write(head.data(), head.size());
    write(bytes, size);
}

ArchiveWriter::ArchiveWriter(fs::path path)
    : path_(std::move(path)),
      temporary_(with_suffix(path_, ".tmp")),
      file_(temporary_, OutputFile::Mode::create) {
    write(magic, sizeof magic);
}

ArchiveWriter::~ArchiveWriter() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void ArchiveWriter::write(const void* bytes, std::size_t size) {
    checksum_.add(bytes, size);
    file_.write(bytes, size);
}

void ArchiveWriter::commit(const fs::path& previous, Durability durability) {
    const std::uint32_t end = 0;
    write(&end, sizeof end);
    const std::uint64_t hash = checksum_.value();
    file_.write(&hash, sizeof hash);
    if (durability == Durability::power) file_.sync();
    file_.close();
    if (!previous.empty()) keep(path_, previous, durability);
    move_into_place(temporary_, path_, durability);
    temporary_.clear();
}

ArchiveReader::ArchiveReader(const fs::path& path) : ArchiveReader(read_file(path), path) {}

ArchiveReader::ArchiveReader(std::string bytes, fs::path path)
    : path_(std::move(path)), bytes_(std::move(bytes)) {
    if (bytes_.size() < sizeof magic + sizeof(std::uint32_t) + sizeof hash_)
        throw_damaged("it is cut short");
    if (std::memcmp(bytes_.data(), magic, sizeof magic) != 0)
        throw_damaged("it is not of this format");
    const std::size_t end = bytes_.size() - sizeof hash_;
    std::memcpy(&hash_, bytes_.data() + end, sizeof hash_);
    if (checksum(std::string_view(bytes_).substr(0, end)) != hash_)
        throw_damaged("its checksum does not match");
    read_sections(end);
}

void ArchiveReader::read_sections(std::size_t end) {
    std::size_t at = sizeof magic;
    const auto read = [&](auto& value) {
        if (end - at < sizeof value) throw_damaged("a section is cut short");
        std::memcpy(&value, bytes_.data() + at, sizeof value);
        at += sizeof value;
    };
    for (;;) {
        std::uint32_t length = 0;
        read(length);
        if (length == 0) break;
        if (end - at < length) throw_damaged("a name is cut short");
        const std::string name = bytes_.substr(at, length);
        at += length;
        Section section{};
        read(section.code);
        read(section.count);
        const std::size_t size = element_size(section.code);
        if (size == 0 || section.count > (end - at) / size)
            throw_damaged(fmt::format("section '{}' is cut short", name));
        section.offset = at;
        at += section.count * size;
        sections_[name] = section;
    }
    if (at != end) throw_damaged("there is more than its sections say");
}

const ArchiveReader::Section& ArchiveReader::find(std::string_view name, char code) const {
    const auto found = sections_.find(prefix_ + std::string(name));
    if (found == sections_.end() || found->second.code != code) {
        throw_damaged(fmt::format("section '{}' is absent or of another type", name));
    }
    return found->second;
}

void ArchiveReader::expect_single(std::string_view name, std::size_t count) const {
    if (count != 1)
        throw_damaged(fmt::format("section '{}' holds {} values, not one", name, count));
}

std::string ArchiveReader::text(std::string_view name) const {
    const std::vector<char> letters = take<char>(name);
    return {letters.begin(), letters.end()};
}

std::vector<std::string> ArchiveReader::names() const {
    std::vector<std::string> all;
    for (const auto& [name, section] : sections_) all.push_back(name);
    return all;
}

void ArchiveReader::throw_damaged(std::string_view what) const {
    throw DamagedArchive(fmt::format("'{}' cannot be loaded: {}", path_.string(), what));
}

}  // namespace tt
