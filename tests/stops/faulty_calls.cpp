// A library to preload before the program: lets one file-system call below a directory fail, or
// kills the process at it. Read from the environment:
//   FAULTY_BELOW   the directory; calls on other files are left alone and not counted
//   FAULTY_ENDS    how the path of a call must end, else it is left alone and not counted too
//   FAULTY_AT      the number of the call, from 1; 0 or absent: none, all are counted
//   FAULTY_ERROR   the errno to fail with; absent: the process is killed before the call
//   FAULTY_HALF    a write at which the process is killed is first done by half
//   FAULTY_LOG     a file that gets a line `number name path` for every call

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

template <class Call>
Call real(Call, const char* name) {
    return reinterpret_cast<Call>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

/// The path as the kernel knows it, where it goes through a descriptor's name.
std::string resolved(const char* path) {
    const std::string given = path;
    if (given.rfind("/proc/self/fd/", 0) != 0) return given;
    const std::size_t slash = given.find('/', 14);
    char target[4096];
    const ssize_t size = readlink(given.substr(0, slash).c_str(), target, sizeof target);
    if (size < 0) return given;
    return std::string(target, static_cast<std::size_t>(size)) +
           (slash == std::string::npos ? "" : given.substr(slash));
}

std::string path_of(int descriptor) {
    return resolved(("/proc/self/fd/" + std::to_string(descriptor)).c_str());
}

bool below(const std::string& path) {
    const std::string directory = setting("FAULTY_BELOW");
    const std::string end = setting("FAULTY_ENDS");
    return !directory.empty() && path.rfind(directory, 0) == 0 && path.size() >= end.size() &&
           path.compare(path.size() - end.size(), end.size(), end) == 0;
}

void log_call(int number, const char* name, const std::string& path) {
    static FILE* const log = [] {
        const char* const file = setting("FAULTY_LOG");
        return *file ? std::fopen(file, "ae") : nullptr;
    }();
    if (!log) return;
    std::fprintf(log, "%d %s %s\n", number, name, path.c_str());
    std::fflush(log);
}

std::atomic<int> calls{0};  ///< of all kinds

/// Counts the call. True if it is the one to fail, with errno set; does not come back if it is the
/// one to be killed at, which `half` precedes.
template <class Half>
bool fails(const char* name, const std::string& path, Half half) {
    if (!below(path)) return false;
    const int number = ++calls;
    log_call(number, name, path);
    if (number != std::atoi(setting("FAULTY_AT"))) return false;
    const int error = std::atoi(setting("FAULTY_ERROR"));
    if (error == 0) {
        if (*setting("FAULTY_HALF")) half();
        raise(SIGKILL);
    }
    errno = error;
    return true;
}
bool fails(const char* name, const std::string& path) {
    return fails(name, path, [] {});
}

int open_mode(int flags, va_list arguments) {
    return (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = open_mode(flags, arguments);
    va_end(arguments);
    if (fails("open", resolved(path))) return -1;
    return real(&open, "open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = open_mode(flags, arguments);
    va_end(arguments);
    if (fails("open", resolved(path))) return -1;
    return real(&open64, "open64")(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = open_mode(flags, arguments);
    va_end(arguments);
    if (fails("open", *path == '/' ? resolved(path) : path_of(folder) + '/' + path)) return -1;
    return real(&openat, "openat")(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    const auto call = real(&write, "write");
    if (fails("write", path_of(descriptor), [&] { (void)!call(descriptor, bytes, count / 2); }))
        return -1;
    return call(descriptor, bytes, count);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t at) {
    const auto call = real(&pwrite64, "pwrite64");
    const auto half = [&] { (void)!call(descriptor, bytes, count / 2, at); };
    if (fails("write", path_of(descriptor), half)) return -1;
    return call(descriptor, bytes, count, at);
}

ssize_t read(int descriptor, void* bytes, size_t count) {
    if (fails("read", path_of(descriptor))) return -1;
    return real(&read, "read")(descriptor, bytes, count);
}

ssize_t pread64(int descriptor, void* bytes, size_t count, off64_t at) {
    if (fails("read", path_of(descriptor))) return -1;
    return real(&pread64, "pread64")(descriptor, bytes, count, at);
}

int close(int descriptor) {
    // Closed it is, as Linux does, whatever is told.
    const bool failed = fails("close", path_of(descriptor));
    const int error = errno;
    const int result = real(&close, "close")(descriptor);
    if (!failed) return result;
    errno = error;
    return -1;
}

int fsync(int descriptor) {
    return fails("fsync", path_of(descriptor)) ? -1 : real(&fsync, "fsync")(descriptor);
}

int fdatasync(int descriptor) {
    return fails("fsync", path_of(descriptor)) ? -1 : real(&fdatasync, "fdatasync")(descriptor);
}

int ftruncate(int descriptor, off_t size) noexcept {
    if (fails("truncate", path_of(descriptor))) return -1;
    return real(&ftruncate, "ftruncate")(descriptor, size);
}

int ftruncate64(int descriptor, off64_t size) noexcept {
    if (fails("truncate", path_of(descriptor))) return -1;
    return real(&ftruncate64, "ftruncate64")(descriptor, size);
}

int rename(const char* from, const char* to) noexcept {
    if (fails("rename", resolved(from) + " " + resolved(to))) return -1;
    return real(&rename, "rename")(from, to);
}

int link(const char* from, const char* to) noexcept {
    return fails("link", resolved(from) + " " + resolved(to)) ? -1 : real(&link, "link")(from, to);
}

int unlink(const char* path) noexcept {
    return fails("unlink", resolved(path)) ? -1 : real(&unlink, "unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) noexcept {
    const std::string whole = *path == '/' ? resolved(path) : path_of(folder) + '/' + path;
    return fails("unlink", whole) ? -1 : real(&unlinkat, "unlinkat")(folder, path, flags);
}

int remove(const char* path) noexcept {
    return fails("unlink", resolved(path)) ? -1 : real(&remove, "remove")(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
    return fails("mkdir", resolved(path)) ? -1 : real(&mkdir, "mkdir")(path, mode);
}

int rmdir(const char* path) noexcept {
    return fails("rmdir", resolved(path)) ? -1 : real(&rmdir, "rmdir")(path);
}

int stat(const char* path, struct stat* status) noexcept {
    return fails("stat", resolved(path)) ? -1 : real(&stat, "stat")(path, status);
}

int lstat(const char* path, struct stat* status) noexcept {
    return fails("stat", resolved(path)) ? -1 : real(&lstat, "lstat")(path, status);
}

int fstat(int descriptor, struct stat* status) noexcept {
    return fails("stat", path_of(descriptor)) ? -1 : real(&fstat, "fstat")(descriptor, status);
}

int flock(int descriptor, int operation) noexcept {
    return fails("flock", path_of(descriptor)) ? -1 : real(&flock, "flock")(descriptor, operation);
}

DIR* opendir(const char* path) {
    return fails("opendir", resolved(path)) ? nullptr : real(&opendir, "opendir")(path);
}

}  // extern "C"
