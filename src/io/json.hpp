#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "io/file.hpp"

namespace tt {

/// Keys keep the order in which they were set, so that a person can read the file.
using Json = nlohmann::ordered_json;

/// Replaces the file in one stroke. Numbers that are not finite become null.
void write_json(const std::filesystem::path& path, const Json& value, Durability durability);

/// IoError if the file cannot be read or is not JSON.
Json read_json(const std::filesystem::path& path);

}  // namespace tt
