#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "observe/results_directory.hpp"

namespace tt {

/// A run to make into a directory of its own, or to go on with.
struct Job {
    std::filesystem::path directory;
    Case c;
    Start start = Start::resume;
    std::optional<Choice> choice = {};  ///< if it is known already: with walls it takes a while
};

/// How a pool of runs stands.
struct PoolStanding {
    int ended = 0, running = 0, waiting = 0;  ///< of the jobs given
    double seconds_left = 0.0;                ///< at the pace so far; NaN while there is none
};

/// How a pool goes about its runs, and what it is watched by.
struct PoolOptions {
    int at_once = 1;           ///< runs side by side, at most
    std::string command_line;  ///< that the runs record
    double max_seconds = std::numeric_limits<double>::infinity();  ///< then stop
    double interval = 1.0;                                         ///< seconds between two `show`
    std::function<void(const PoolStanding&)> show = {};
    std::function<void(const Job&, int code)> ended = {};  ///< a run has ended so
    std::function<void()> in_child = {};  ///< first of all in the process of a run
};

/// What a run left in its directory.
enum class JobEnd { none, done, unstable };
JobEnd end_of(const std::filesystem::path& directory);

/// The first line of what a run said as it failed.
std::string failure_of(const std::filesystem::path& directory);

/// How much memory a run of so many sites takes [bytes].
double expected_bytes(const Choice& choice);

/// Makes the runs side by side, each in a process of its own, so that one that crashes takes none
/// with it: as many as asked for, and no more than fit into memory. Where there are more processors
/// than runs, each gets its share of threads. A run that was stopped goes on where it was; one that
/// turns out unstable is an answer like another; one in whose directory another process writes
/// waits for that. Returns exit_code::done once every run has ended, stopped_early if a signal or
/// the clock asked to stop, input_output as soon as one cannot write, else the exit code of a run
/// that went wrong otherwise, after the others. Those cut short are stopped such that they go on.
int run_side_by_side(std::span<const Job> jobs, const PoolOptions& options);

}  // namespace tt
