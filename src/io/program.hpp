#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tt {

/// Whether a program of this name is on the path.
bool has_program(const std::string& name);

/// Runs a program, found on the path, in `directory`, and waits for its end. No shell sees its
/// arguments. What it says goes to the file `log` in that directory. Returns its exit code, or 128
/// + the signal that ended it; IoError if it cannot be started.
int run_program(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                const std::string& log);

}  // namespace tt
