#pragma once

#include <string>

#include "case/case.hpp"

namespace tt {

/// The case as a case file with every key, its meaning beside it. Reads back to the same Case, bit
/// for bit; a key without a value stands as a comment.
std::string to_toml(const Case& given);

/// The same, bare: a line `table.key = value` for every key, `auto` for one without a value.
std::string key_lines(const Case& given);

}  // namespace tt
