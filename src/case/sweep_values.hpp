#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// Values that cannot be read. The message says what is wrong and what to write.
class SweepError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Each value of a list as it stands after --set KEY=: "0.1, 0.2, 0.5", whose items may be ranges,
/// "0.1:1:0.1" or "0.1:10:*10". A unit behind the last number is that of all: "20, 40 um". The
/// values of a range have at most twelve digits. Throws SweepError.
std::vector<std::string> listed_settings(std::string_view text);

/// `text` cut at `separator`, but not within quotes or brackets; each part without spaces round it.
std::vector<std::string_view> cut(std::string_view text, char separator);

/// `text` without spaces round it.
std::string_view trimmed(std::string_view text);

}  // namespace tt
