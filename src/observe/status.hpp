#pragma once

#include <filesystem>
#include <string>

#include "io/json.hpp"
#include "observe/pace.hpp"

namespace tt {

/// Replaces status.json. `phase` is running, stopped, done or failed.
void write_status(const std::filesystem::path& results, const Standing& standing,
                  const std::string& phase);

/// What status.json says; a run that says `running` but holds no lock was killed and reads
/// `interrupted`. IoError if the directory has none.
Json read_status(const std::filesystem::path& results);

/// The same for people, a few lines.
std::string describe_status(const Json& status);

/// Now, as 2024-05-01T12:34:56Z.
std::string utc_now();

}  // namespace tt
