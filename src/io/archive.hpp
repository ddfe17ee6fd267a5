#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "io/checksum.hpp"
#include "io/file.hpp"

namespace tt {

/// The archive is cut short, altered or of another format: never loaded.
class DamagedArchive : public IoError {
public:
    using IoError::IoError;
};

/// One letter per element type, stored with each section so that a double is never read as an
/// integer.
template <class T>
constexpr char element_code() {
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::int32_t> ||
                  std::is_same_v<T, std::int64_t> || std::is_same_v<T, char>);
    if constexpr (std::is_same_v<T, double>)
        return 'd';
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return 'i';
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return 'l';
    else
        return 'c';
}

/// Takes named arrays, one after the other.
class ArchiveOutput {
public:
    virtual ~ArchiveOutput() = default;

    /// Names put from now on have `prefix` before them.
    void enter(std::string prefix) { prefix_ = std::move(prefix); }

    template <class T>
    void put(std::string_view name, std::span<const T> values) {
        put_bytes(prefix_ + std::string(name), element_code<T>(), values.size(), values.data(),
                  values.size_bytes());
    }
    template <class T>
    void put(std::string_view name, const std::vector<T>& values) {
        put(name, std::span<const T>(values));
    }
    template <class T>
    void put_value(std::string_view name, T value) {
        put(name, std::span<const T>(&value, 1));
    }
    void put_text(std::string_view name, std::string_view text) {
        put(name, std::span<const char>(text));
    }

private:
    void put_bytes(std::string_view name, char code, std::uint64_t count, const void* bytes,
                   std::size_t size);
    virtual void write(const void* bytes, std::size_t size) = 0;

    std::string prefix_;
};

/// Named arrays kept in memory, to be put into an archive later.
class ArchiveBuffer : public ArchiveOutput {
public:
    const std::string& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

private:
    void write(const void* bytes, std::size_t size) override {
        bytes_.append(static_cast<const char*>(bytes), size);
    }
    std::string bytes_;
};

/// Named arrays in one binary file: the magic word, then per section the length of its name (u32),
/// the name, the element code (1 byte), the count (u64) and the elements as they lie in memory; a
/// name of length 0; XXH64 of everything before. Written beside its place and moved there by
/// `commit`, so the place holds an old whole archive or a new one.
class ArchiveWriter : public ArchiveOutput {
public:
    explicit ArchiveWriter(std::filesystem::path path);
    ~ArchiveWriter() override;
    ArchiveWriter(const ArchiveWriter&) = delete;
    ArchiveWriter& operator=(const ArchiveWriter&) = delete;

    /// All that was put into `buffer`.
    void put_all(const ArchiveBuffer& buffer) {
        write(buffer.bytes().data(), buffer.bytes().size());
    }

    /// Finishes the archive and moves it into its place. What stood there stays as `previous`. With
    /// Durability::process it returns before the archive is on the disk.
    void commit(const std::filesystem::path& previous, Durability durability = Durability::power);
    /// The same, keeping nothing of what stood there.
    void commit() { commit({}); }

private:
    void write(const void* bytes, std::size_t size) override;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    OutputFile file_;
    Checksum checksum_;
};

/// Reads an archive whole and checks it before anything of it is used. DamagedArchive if it is not
/// sound.
class ArchiveReader {
public:
    explicit ArchiveReader(const std::filesystem::path& path);
    /// Of the `bytes` of the file `path`.
    ArchiveReader(std::string bytes, std::filesystem::path path);

    /// Names asked for from now on have `prefix` before them.
    void enter(std::string prefix) { prefix_ = std::move(prefix); }

    bool has(std::string_view name) const {
        return sections_.count(prefix_ + std::string(name)) > 0;
    }
    /// The section `name`. DamagedArchive if it is absent or of another type.
    template <class T>
    std::vector<T> take(std::string_view name) const {
        const Section& section = find(name, element_code<T>());
        std::vector<T> values(section.count);
        if (section.count > 0)
            std::memcpy(values.data(), bytes_.data() + section.offset, section.count * sizeof(T));
        return values;
    }
    template <class T>
    T value(std::string_view name) const {
        const std::vector<T> values = take<T>(name);
        expect_single(name, values.size());
        return values.front();
    }
    std::string text(std::string_view name) const;
    std::vector<std::string> names() const;
    std::uint64_t hash() const { return hash_; }

private:
    struct Section {
        char code;
        std::uint64_t count;
        std::size_t offset;
    };
    const Section& find(std::string_view name, char code) const;
    void expect_single(std::string_view name, std::size_t count) const;
    [[noreturn]] void throw_damaged(std::string_view what) const;
    void read_sections(std::size_t end);

    std::filesystem::path path_;
    std::string prefix_;
    std::string bytes_;
    std::map<std::string, Section> sections_;
    std::uint64_t hash_ = 0;
};

}  // namespace tt
