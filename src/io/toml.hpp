#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tt {

struct TomlEntry;

/// A value of a TOML text and where it stands. Only the member of its kind is set; `written` is how
/// to show it.
struct TomlNode {
    enum class Kind : std::uint8_t { string, integer, real, boolean, date, array, table };

    Kind kind = Kind::table;
    std::string text;
    std::int64_t integer = 0;
    double real = 0.0;
    bool boolean = false;
    std::vector<TomlNode> items;
    std::vector<TomlEntry> entries;  ///< in the order of the text
    int line = 0;
    int column = 0;

    const TomlEntry* find(std::string_view key) const;
    TomlEntry* find(std::string_view key);
};

struct TomlEntry {
    std::string key;
    int line = 0;
    int column = 0;
    TomlNode value;
    std::string origin;  ///< empty for the file, else the command-line option that set it
};

/// A text read as TOML 1.0, or what stops it from being that.
struct TomlText {
    TomlNode root;
    std::vector<Fault> faults;
};

/// Reads `text`; `name` is the file named in faults. Lines and columns count from 1, in characters.
/// µ and μ become u; other letters beyond ASCII may stand in comments only. Every fault found is
/// told, not only the first: a faulty line is left out and the rest read on. Never throws and never
/// aborts, whatever the text (tests/unit/toml.cpp, tests/fuzz).
TomlText parse_toml(std::string_view text, const std::string& name);

/// One value as in `key = value`; nothing of it is a fault: what is not TOML is a string. For
/// options of the command line.
TomlNode parse_toml_value(const std::string& text);

/// `text` as a TOML string with its quotes and escapes, in ASCII.
std::string toml_string(std::string_view text);

}  // namespace tt
