#include "observe/results_directory.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

fs::path lock_file(const fs::path& results) { return results / ".lock"; }

bool holds_results(const fs::path& path) {
    return fs::exists(path / "PROVENANCE.json") || fs::exists(path / "checkpoint");
}

/// A run that was killed before it wrote PROVENANCE.json, its first file, leaves at most these.
bool holds_something(const fs::path& path) {
    constexpr std::array leftovers{".lock", "run.log", "PROVENANCE.json.tmp"};
    for (const auto& entry : fs::directory_iterator(path)) {
        const std::string name = entry.path().filename().string();
        if (std::find(leftovers.begin(), leftovers.end(), name) == leftovers.end()) return true;
    }
    return false;
}

void expect_results(const fs::path& path) {
    if (!fs::exists(path)) return;
    if (!fs::is_directory(path))
        throw DirectoryInUse(fmt::format("'{}' is a file, not a directory", path.string()));
    if (holds_something(path) && !holds_results(path)) {
        throw DirectoryInUse(
            fmt::format("'{}' holds files but no results of ours; choose another directory with -o",
                        path.string()));
    }
}

}  // namespace

void DirectoryLock::acquire(const fs::path& directory) {
    const fs::path file = lock_file(directory);
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
        throw IoError(fmt::format("cannot open '{}': {}", file.string(), std::strerror(errno)));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int code = errno;
    release();
    if (code == EWOULDBLOCK) {
        throw DirectoryInUse(fmt::format(
            "another process is writing to '{}'; wait for it or choose another directory with "
            "-o",
            directory.string()));
    }
    throw IoError(fmt::format("cannot lock '{}': {}", file.string(), std::strerror(code)));
}

void DirectoryLock::release() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
}

ResultsDirectory::ResultsDirectory(const fs::path& path, Start start) : path_(path) {
    expect_results(path_);
    make_directory(path_);
    lock_.acquire(path_);
    if (start == Start::resume || !holds_results(path_)) return;
    move_aside();
    lock_.acquire(path_);
}

void ResultsDirectory::move_aside() {
    fs::path base = path_;
    if (!base.has_filename()) base = base.parent_path();   // "results/name/"
    if (fs::is_symlink(base)) base = fs::canonical(base);  // its disk was chosen; the link stays
    int number = 1;
    do {
        moved_to_ = base;
        moved_to_ += fmt::format(".{}", number++);
    } while (fs::exists(moved_to_));
    move_into_place(base, moved_to_, Durability::power);
    lock_.release();
    make_directory(base);
}

bool is_running(const fs::path& results) {
    const int descriptor = ::open(lock_file(results).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(descriptor);
    return held;
}

}  // namespace tt
