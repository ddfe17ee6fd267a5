#pragma once

#include <filesystem>
#include <string>

#include "io/json.hpp"
#include "observe/pace.hpp"

namespace tt {

/// Replaces status.json. `phase` is running, stopped, done or failed.
void write_status(const std::filesystem::path& results, const Standing& standing,
                  const std::string& phase);

/// Is summary.json there, and sound? It is the last file of a run.
bool has_summary(const std::filesystem::path& results);

/// What status.json says, as it stands; an empty object if there is none or it is damaged.
Json recorded_status(const std::filesystem::path& results);

/// The same in the light of what is there: a run that holds no lock and did not come to its
/// summary.json, though it says `running` or `done`, was killed and reads `interrupted`. IoError if
/// the directory holds no run.
Json read_status(const std::filesystem::path& results);

/// The same for people, a few lines.
std::string describe_status(const Json& status);

/// Now, as 2024-05-01T12:34:56Z.
std::string utc_now();

}  // namespace tt
