#pragma once

#include <cstdio>
#include <exception>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "io/frames.hpp"
#include "io/json.hpp"
#include "simulation/stop.hpp"
#include "small_run.hpp"
#include "temporary_directory.hpp"

namespace tt {

namespace fs = std::filesystem;

/// A directory for runs, and no request to stop from the test before.
class RunsTest : public TemporaryDirectory {
protected:
    RunsTest() { clear_stop_request(); }
    ~RunsTest() override { clear_stop_request(); }
};

/// Runs `work` in a process of its own; its exit status, or −signal.
template <class Work>
pid_t in_a_child(Work work) {
    const pid_t child = fork();
    if (child != 0) return child;
    int code = 0;
    try {
        work();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        code = 5;
    }
    _exit(code);
}

inline int ending_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

inline void expect_same_results(const fs::path& a, const fs::path& b) {
    EXPECT_EQ(read_json(a / "PROVENANCE.json")["state_hash"],
              read_json(b / "PROVENANCE.json")["state_hash"]);
    for (const char* name : {"series.csv", "cells.csv", "profiles.csv"}) {
        EXPECT_EQ(read_file(a / name), read_file(b / name)) << name;
    }
    const FramesReader of_a(a / "frames.h5");
    const FramesReader of_b(b / "frames.h5");
    ASSERT_EQ(of_a.count(), of_b.count());
    for (int k = 0; k < of_a.count(); ++k) {
        const Frame x = of_a.frame(k);
        const Frame y = of_b.frame(k);
        EXPECT_EQ(x.step, y.step);
        EXPECT_EQ(x.nodes, y.nodes);
        EXPECT_EQ(x.node_force, y.node_force);
        EXPECT_EQ(x.velocity, y.velocity);
        EXPECT_EQ(x.pressure, y.pressure);
        EXPECT_EQ(x.cytoplasm, y.cytoplasm);
    }
}

/// Stops after the first checkpoints, so that current and previous exist.
inline void stop_midway(RunRequest request) {
    for (const double part : {0.2, 0.45}) {
        request.until = Time{part * request.end.si};
        ASSERT_EQ(run_small(request).ending, RunOutcome::Ending::stopped);
    }
}

}  // namespace tt
