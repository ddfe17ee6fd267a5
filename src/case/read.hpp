#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace tt {

/// Reads a case file. `overrides` are "table.key=value", as after --set; they follow the rules of
/// the file, but words and quantities need no quotes, and one of two keys that exclude each other
/// takes the place of the other. Throws CaseError with every fault found (file:line:column, and
/// what to write), IoError if the file cannot be read.
Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same from a text; `name` stands for the file in faults, paths in the text start at
/// `directory`. Without a directory no file that the text names is opened.
Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides = {},
                const std::filesystem::path& directory = {});

/// What stands in faults of an override in the place of the file.
std::string origin_of(const std::string& item);

}  // namespace tt
