#include "observe/results_directory.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/file.hpp"
#include "io/json.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

fs::path lock_file(const fs::path& results) { return results / ".lock"; }
fs::path marker(const fs::path& results) { return results / "PROVENANCE.json"; }

/// A run that was killed before it wrote its marker leaves at most these.
bool holds_something(const fs::path& path) {
    for (const auto& entry : fs::directory_iterator(path)) {
        if (entry.path().filename() != ".lock" && entry.path().filename() != "run.log") return true;
    }
    return false;
}

void expect_results(const fs::path& path) {
    if (!fs::exists(path)) return;
    if (!fs::is_directory(path))
        throw DirectoryInUse(fmt::format("'{}' is a file, not a directory", path.string()));
    if (holds_something(path) && !fs::exists(marker(path))) {
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

ResultsDirectory::ResultsDirectory(const fs::path& path, const std::string& case_hash, Start start)
    : path_(path) {
    expect_results(path_);
    make_directory(path_);
    lock_.acquire(path_);
    if (!fs::exists(marker(path_))) return;
    if (start == Start::fresh) {
        move_aside();
        lock_.acquire(path_);
        return;
    }
    const Json known = read_json(marker(path_));
    if (known.value("case_hash", std::string()) != case_hash) {
        throw DirectoryInUse(fmt::format(
            "'{}' holds results of another case ('{}'); choose another directory with -o, or "
            "move it aside with --fresh",
            path_.string(), known.value("name", "?")));
    }
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
