#pragma once

#include <filesystem>

#include "case/sweep_plan.hpp"
#include "observe/results_directory.hpp"

namespace tt {

/// The directory of a sweep: held by one process, and only ever added to.
class SweepDirectory {
public:
    /// Makes it, or takes over one of a sweep. With Start::fresh that is first renamed to `path.1`,
    /// `path.2`, … Throws DirectoryInUse if another process holds it or `expect_sweep` refuses.
    SweepDirectory(const std::filesystem::path& path, const SweepPlan& plan, Start start);

    /// Throws DirectoryInUse if there is something else than a sweep.
    static void expect_sweep(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return path_; }
    /// Where the former sweep went; empty if nothing was moved.
    const std::filesystem::path& moved_to() const { return moved_to_; }
    /// In a child process: the directory is the parent's alone.
    void leave_to_parent() { lock_.leave_to_parent(); }

private:
    std::filesystem::path path_, moved_to_;
    DirectoryLock lock_;
};

}  // namespace tt
