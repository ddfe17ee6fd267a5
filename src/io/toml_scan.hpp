#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tt {

/// A case file as the TOML parser may see it: ASCII only.
struct AsciiText {
    std::string text;
    std::vector<Fault> faults;
};

/// Maps µ and μ to u, every other letter beyond ASCII in a comment to '?', and makes a fault of it
/// elsewhere: one letter stays one column. Drops a UTF-8 byte order mark. Texts beyond 1 MiB,
/// UTF-16, control characters and nesting deeper than any case needs are faults.
AsciiText to_ascii(std::string_view text, const std::string& name);

}  // namespace tt
