#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tt {

/// Go on with what a results directory holds, or move it aside and begin anew.
enum class Start { resume, fresh };

/// Held by one process at a time, until it is released or the process ends, however it ends: the
/// kernel drops it, so that no stale lock can be left. Where the file system has no locks, a file
/// `.owner` with the host and the process stands for it; one of a process of this host that is gone
/// is taken over.
class DirectoryLock {
public:
    DirectoryLock() = default;
    ~DirectoryLock() { release(); }
    DirectoryLock(const DirectoryLock&) = delete;
    DirectoryLock& operator=(const DirectoryLock&) = delete;

    /// Throws DirectoryInUse if another process holds it.
    void acquire(const std::filesystem::path& directory);
    void release();
    /// In a child process: the lock is the parent's alone, and goes with it.
    void leave_to_parent();
    /// Where the directory is, if that is not where it was.
    std::optional<std::filesystem::path> moved() const;

private:
    std::filesystem::path directory_;
    int descriptor_ = -1;
    bool owner_ = false;  ///< by a file, not by the kernel
};

/// Renames a directory to the first of `path.1`, `path.2`, … that is free, beside where it lies
/// itself: a link stays where it is. Returns the new name.
std::filesystem::path move_aside(const std::filesystem::path& path);

/// A results directory that this process alone writes to, until the object ends.
class ResultsDirectory {
public:
    /// Makes the directory or takes over one that holds results. With Start::fresh these are first
    /// renamed to `path.1`, `path.2`, … Throws DirectoryInUse if another process holds it, or if it
    /// holds something else than results; IoError if it cannot be made.
    ResultsDirectory(const std::filesystem::path& path, Start start);

    /// Leaves everything as the constructor found it: for a run that is refused before it begins,
    /// with nothing written but its log.
    void withdraw();

    const std::filesystem::path& path() const { return path_; }
    /// Where the former content went; empty if nothing was moved.
    const std::filesystem::path& moved_to() const { return moved_to_; }
    /// Where somebody has moved it to while we hold it, if anywhere.
    std::optional<std::filesystem::path> lies_elsewhere() const { return lock_.moved(); }

private:
    void move_aside();

    std::filesystem::path path_;
    std::filesystem::path made_;  ///< the uppermost directory that was made; empty: none
    std::filesystem::path moved_to_;
    DirectoryLock lock_;
};

/// Does some process hold the directory?
bool is_running(const std::filesystem::path& results);

}  // namespace tt
