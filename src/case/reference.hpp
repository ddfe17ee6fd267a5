#pragma once

#include <string>
#include <string_view>

namespace tt {

/// The reference of keys for a terminal of 80 columns: of the keys with `word` in their full name
/// (table.key), and the names of those with it in their meaning; all if it is empty. If none has it
/// in its name, those with it in their meaning. Empty if nothing matches.
std::string reference_text(std::string_view word = {});

/// The same as a page: docs/keys.md.
std::string reference_markdown();

}  // namespace tt
