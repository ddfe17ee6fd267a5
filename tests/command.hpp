#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace tt {

/// What a command left: its exit code and all it printed.
struct Outcome {
    int code = 0;
    std::string out;
    std::string err;
};

/// Runs `tanktread WORDS` in this process.
inline Outcome run(const std::vector<std::string>& words) {
    std::vector<const char*> arguments{"tanktread"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = run_command_line(static_cast<int>(arguments.size()), arguments.data());
    std::fflush(stdout);
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
}

}  // namespace tt
