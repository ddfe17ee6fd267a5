#include "io/file.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/memory.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_io(const char* verb, const fs::path& path, int code) {
    throw IoError(fmt::format("cannot {} '{}': {}", verb, path.string(), std::strerror(code)));
}

/// The most bytes that are read into memory.
std::uint64_t size_limit(Author author) {
    if (author == Author::user) return std::uint64_t{16} << 20;
    static const auto usable = static_cast<std::uint64_t>(usable_memory());
    return usable;
}

/// A file being read. It is opened without waiting: a pipe without a writer, or a file of the
/// system that has nothing to say yet, must not hold up the program for ever.
class Input {
public:
    explicit Input(const fs::path& path)
        : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        if (descriptor_ < 0) throw_io("open", path_, errno);
    }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;
    ~Input() { ::close(descriptor_); }

    std::string read(Author author) {
        const std::uint64_t limit = size_limit(author);
        std::string text;
        text.reserve(expected_size(author, limit));
        char block[1 << 16];
        while (const std::size_t count = next(block, sizeof block)) {
            text.append(block, count);
            expect_within(text.size(), limit);
        }
        return text;
    }

private:
    /// Of a file that may be read at all.
    std::size_t expected_size(Author author, std::uint64_t limit) {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0) throw_io("read", path_, errno);
        if (S_ISDIR(status.st_mode)) throw_io("read", path_, EISDIR);
        pipe_ = S_ISFIFO(status.st_mode) && author == Author::user;
        if (!S_ISREG(status.st_mode) && !pipe_) refuse("it is a device or a pipe, not a file");
        expect_within(static_cast<std::uint64_t>(status.st_size), limit);
        return static_cast<std::size_t>(status.st_size);
    }

    std::size_t next(char* block, std::size_t size) {
        constexpr int glance = 200, patience = 10'000;  // ms
        for (int waited = 0;;) {
            pollfd wait{descriptor_, POLLIN, 0};
            const bool silent = ::poll(&wait, 1, glance) == 0;
            const ssize_t count = ::read(descriptor_, block, size);
            if (count == 0 && silent && pipe_)
                refuse("it is a pipe, not a file, and nobody writes into it");
            if (count >= 0) return static_cast<std::size_t>(count);
            if (errno != EINTR && errno != EAGAIN) throw_io("read", path_, errno);
            if (silent && (waited += glance) >= patience) refuse("nothing came out of it for 10 s");
        }
    }

    void expect_within(std::uint64_t bytes, std::uint64_t limit) const {
        if (bytes > limit) refuse(fmt::format("it has more than {} MB", limit / 1'000'000));
    }

    [[noreturn]] void refuse(const std::string& why) const {
        throw IoError(fmt::format("cannot read '{}': {}", path_.string(), why));
    }

    const fs::path& path_;
    int descriptor_;
    bool pipe_ = false;
};

}  // namespace

OutputFile::OutputFile(fs::path path, Mode mode) : path_(std::move(path)) {
    const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | (mode == Mode::create ? O_TRUNC : O_APPEND);
    descriptor_ = ::open(path_.c_str(), flags, 0644);
    if (descriptor_ < 0) fail("open for writing");
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

void OutputFile::fail(const char* verb) const { throw_io(verb, path_, errno); }

void OutputFile::write(const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = ::write(descriptor_, next, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write");
        next += written;
        count -= static_cast<std::size_t>(written);
    }
}

void OutputFile::write_at(std::uint64_t offset, const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = ::pwrite(descriptor_, next, count, static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("write");
        next += written;
        offset += static_cast<std::uint64_t>(written);
        count -= static_cast<std::size_t>(written);
    }
}

void OutputFile::append(std::string_view text) {
    const std::int64_t before = size();
    try {
        write(text.data(), text.size());
    } catch (const IoError& error) {
        if (::ftruncate(descriptor_, before) != 0)
            throw IoError(fmt::format("{}; what was written of it cannot be undone: {}",
                                      error.what(), std::strerror(errno)));
        throw;
    }
}

void OutputFile::sync() {
    if (::fsync(descriptor_) != 0) fail("sync");
}

void OutputFile::cut(std::int64_t size) {
    if (size > this->size()) {
        throw IoError(
            fmt::format("'{}' is shorter ({} bytes) than the checkpoint says ({} bytes): "
                        "rows are lost; begin anew with --fresh, which keeps what is "
                        "there beside",
                        path_.string(), this->size(), size));
    }
    if (::ftruncate(descriptor_, size) != 0) fail("truncate");
}

std::int64_t OutputFile::size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail("ask the size of");
    return status.st_size;
}

void OutputFile::close() {
    const int descriptor = std::exchange(descriptor_, -1);
    if (descriptor >= 0 && ::close(descriptor) != 0) fail("close");
}

void sync_file(const fs::path& path) { OutputFile(path, OutputFile::Mode::append).sync(); }

void sync_directory(const fs::path& file) {
    const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) throw_io("open", directory, errno);
    // Some file systems cannot sync a directory (EINVAL); the rename itself has succeeded by then.
    if (::fsync(descriptor) != 0 && errno != EINVAL) {
        const int code = errno;
        ::close(descriptor);
        throw_io("sync", directory, code);
    }
    ::close(descriptor);
}

void move_into_place(const fs::path& from, const fs::path& to, Durability durability) {
    if (::rename(from.c_str(), to.c_str()) != 0) throw_io("replace", to, errno);
    if (durability == Durability::power) sync_directory(to);
}

void replace_file(const fs::path& path, std::string_view bytes, Durability durability) {
    fs::path temporary = path;
    temporary += ".tmp";
    with_second_try([&] {
        try {
            OutputFile file(temporary, OutputFile::Mode::create);
            file.write(bytes.data(), bytes.size());
            if (durability == Durability::power) file.sync();
            file.close();
        } catch (const IoError&) {
            std::error_code ignored;
            fs::remove(temporary, ignored);
            throw;
        }
        move_into_place(temporary, path, durability);
    });
}

std::string read_file(const fs::path& path, Author author) { return Input(path).read(author); }

void make_directory(const fs::path& path) {
    std::error_code code;
    fs::create_directories(path, code);
    if (code) throw_io("create the directory", path, code.value());
}

}  // namespace tt
