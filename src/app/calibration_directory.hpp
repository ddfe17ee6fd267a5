#pragma once

#include <filesystem>

#include "case/targets.hpp"
#include "observe/results_directory.hpp"

namespace tt {

/// The directory of a calibration: held by one process, and only ever added to.
class CalibrationDirectory {
public:
    /// Makes it, or takes over one of a calibration. The answer to other targets or inputs goes to
    /// a folder in it. Throws DirectoryInUse if another process holds it or a run lies there.
    CalibrationDirectory(const std::filesystem::path& path, const Targets& targets);

    const std::filesystem::path& path() const { return path_; }
    /// Where the answer to other targets went; empty if nothing was moved.
    const std::filesystem::path& moved_to() const { return moved_to_; }
    /// In a child process: the directory is the parent's alone.
    void leave_to_parent() { lock_.leave_to_parent(); }

private:
    /// The runs stay, since their names tell what they are of.
    void move_answer_aside();

    std::filesystem::path path_, moved_to_;
    DirectoryLock lock_;
};

}  // namespace tt
