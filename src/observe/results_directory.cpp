#include "observe/results_directory.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
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
    constexpr std::array leftovers{".lock", ".owner", "run.log", "PROVENANCE.json.tmp"};
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

/// Where it lies itself: of "results/name/" without the slash; of a link where that leads, as its
/// disk was chosen and the link stays.
fs::path own_place(const fs::path& path) {
    const fs::path named = path.has_filename() ? path : path.parent_path();
    return fs::is_symlink(named) ? fs::canonical(named) : named;
}

/// Of the directory and those it is in, the uppermost that does not exist.
fs::path first_absent(fs::path path) {
    fs::path absent;
    for (; !path.empty() && !fs::exists(path); path = path.parent_path()) absent = path;
    return absent;
}

bool has_no_locks(int code) { return code == ENOSYS || code == EOPNOTSUPP || code == ENOLCK; }

fs::path owner_file(const fs::path& results) { return results / ".owner"; }

std::string host() {
    char name[256] = "";
    ::gethostname(name, sizeof name - 1);
    return name;
}

std::string owner_of(const fs::path& results) {
    std::ifstream file(owner_file(results));
    std::string line;
    std::getline(file, line);
    return line;
}

/// By a process that may be alive: of another host, or one of this that is.
bool is_owned(const fs::path& results) {
    std::istringstream owner(owner_of(results));
    std::string on;
    pid_t process = 0;
    if (!(owner >> on >> process)) return fs::exists(owner_file(results));
    return on != host() || ::kill(process, 0) == 0 || errno == EPERM;
}

/// Makes us the owner, unless somebody is.
bool own(const fs::path& results) {
    std::error_code ignored;
    if (!is_owned(results)) fs::remove(owner_file(results), ignored);
    const int file =
        ::open(owner_file(results).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file < 0) return false;
    const std::string line = fmt::format("{} {}\n", host(), ::getpid());
    const bool written =
        ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    ::close(file);
    return written;
}

}  // namespace

void DirectoryLock::acquire(const fs::path& directory) {
    const fs::path file = lock_file(directory);
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
        throw IoError(fmt::format("cannot open '{}': {}", file.string(), std::strerror(errno)));
    directory_ = directory;
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int code = errno;
    if (has_no_locks(code) && own(directory)) {
        owner_ = true;
        return;
    }
    const std::string owner = has_no_locks(code) ? owner_of(directory) : "";
    release();
    if (code != EWOULDBLOCK && owner.empty())
        throw IoError(fmt::format("cannot lock '{}': {}", file.string(), std::strerror(code)));
    throw DirectoryInUse(fmt::format(
        "another process{} is writing to '{}'; wait for it or choose another directory with -o{}",
        owner.empty() ? "" : " (" + owner + ")", directory.string(),
        owner.empty() ? "" : ". If it is gone, delete " + owner_file(directory).string()));
}

void DirectoryLock::release() {
    std::error_code ignored;
    if (owner_) fs::remove(owner_file(directory_), ignored);
    owner_ = false;
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
}

void DirectoryLock::leave_to_parent() {
    owner_ = false;
    release();
}

std::optional<fs::path> DirectoryLock::moved() const {
    struct stat held {
    }, there{};
    if (descriptor_ < 0 || ::fstat(descriptor_, &held) != 0) return std::nullopt;
    const bool same = ::stat(lock_file(directory_).c_str(), &there) == 0 &&
                      held.st_ino == there.st_ino && held.st_dev == there.st_dev;
    std::error_code code;
    const fs::path place = fs::read_symlink(fmt::format("/proc/self/fd/{}", descriptor_), code);
    if (same || code || held.st_nlink == 0) return std::nullopt;
    return place.parent_path();
}

fs::path move_aside(const fs::path& path) {
    const fs::path base = own_place(path);
    fs::path free;
    int number = 1;
    do {
        free = base;
        free += fmt::format(".{}", number++);
    } while (fs::exists(free));
    move_into_place(base, free, Durability::power);
    return free;
}

ResultsDirectory::ResultsDirectory(const fs::path& path, Start start)
    : path_(path), made_(first_absent(path)) {
    expect_results(path_);
    make_directory(path_);
    lock_.acquire(path_);
    if (start == Start::resume || !holds_results(path_)) return;
    move_aside();
    lock_.acquire(path_);
}

void ResultsDirectory::move_aside() {
    const fs::path base = own_place(path_);
    moved_to_ = tt::move_aside(path_);
    lock_.release();
    make_directory(base);
}

void ResultsDirectory::withdraw() {
    // Still ours: nobody begins in it meanwhile.
    if (!holds_results(path_) && !holds_something(path_)) {
        std::error_code ignored;
        if (!moved_to_.empty()) {
            const fs::path base = own_place(path_);
            fs::remove_all(base);
            move_into_place(std::exchange(moved_to_, {}), base, Durability::power);
        } else if (!made_.empty()) {
            fs::remove_all(path_);
            // Those it is in may have got other runs since.
            for (fs::path up = path_; up != made_ && !ignored;)
                fs::remove(up = up.parent_path(), ignored);
        }
    }
    lock_.release();
}

bool is_running(const fs::path& results) {
    const int descriptor = ::open(lock_file(results).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool free = ::flock(descriptor, LOCK_SH | LOCK_NB) == 0;
    const int code = errno;
    ::close(descriptor);
    if (free) return false;
    return code == EWOULDBLOCK || (has_no_locks(code) && is_owned(results));
}

}  // namespace tt
