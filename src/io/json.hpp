#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "io/file.hpp"

namespace tt {

/// Keys keep the order in which they were set, so that a person can read the file.
using Json = nlohmann::ordered_json;

/// null where `value` is not finite.
Json number(double value);

/// Replaces the file in one stroke. Numbers that are not finite become null.
void write_json(const std::filesystem::path& path, const Json& value, Durability durability);

/// IoError if the file cannot be read or is not JSON.
Json read_json(const std::filesystem::path& path);

/// The object that the file holds; an empty one if there is no such file, or it is damaged.
Json read_object(const std::filesystem::path& path);

/// The value of `key` in what was read from a file; `otherwise` if it is absent or of another kind.
double number_of(const Json& object, const char* key, double otherwise);
std::int64_t whole_number_of(const Json& object, const char* key, std::int64_t otherwise);
std::string text_of(const Json& object, const char* key, const std::string& otherwise = "");

}  // namespace tt
