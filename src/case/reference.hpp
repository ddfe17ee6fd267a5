#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// One key of the case file as reference, manual and completion show it.
struct KeyLine {
    std::string full_name;  ///< "flow.drive"
    std::string example;    ///< `drive = "pressure"`: the value in force without the key, if any
    std::string bounds;     ///< words or range; empty if any value will do
    std::string meaning;
    std::vector<std::string> words;  ///< the words that it takes, if it takes words
    bool required = false;
};

/// A table of the case file.
struct KeyTable {
    std::string name;    ///< "membrane.hardening"; empty for the top
    std::string header;  ///< "[membrane.hardening]", "[[kind]]"
    std::string meaning;
    std::vector<KeyLine> keys;
};

/// All keys that there are, from the lists that the program reads by.
std::vector<KeyTable> reference_tables();

/// How a value of a key is written, with its units: Markdown.
extern const std::string_view how_to_write_values;

/// The reference of keys for a terminal of 80 columns: of the keys with `word` in their full name
/// (table.key), and the names of those with it in their meaning; all if it is empty. If none has it
/// in its name, those with it in their meaning. Empty if nothing matches.
std::string reference_text(std::string_view word = {});

/// The same as a page: docs/keys.md.
std::string reference_markdown();

}  // namespace tt
