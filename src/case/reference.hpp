#pragma once

#include <string>
#include <string_view>

namespace tt {

/// The reference of keys for a terminal of 80 columns: of the table named, of the keys that contain
/// `word`, or all of them if it is empty. Empty if nothing matches.
std::string reference_text(std::string_view word = {});

/// The same as a page: docs/keys.md.
std::string reference_markdown();

}  // namespace tt
