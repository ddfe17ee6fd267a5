#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tt {

/// What the value of an option or an argument is. Manual and completion read it, as CLI11's name of
/// a type. An option that takes one of some words has them there: "vtk|csv|png".
namespace value_kind {
inline constexpr const char* toml_file = "FILE";
inline constexpr const char* directory = "DIR";
inline constexpr const char* any_file = "PATH";  ///< no case: drawings, tables, pictures
inline constexpr const char* length = "LENGTH";
inline constexpr const char* setting = "KEY=VALUE";  ///< a key of the case file, set
inline constexpr const char* axis = "KEY=VALUES";    ///< a key of the case file and its values
inline constexpr const char* key = "KEY";            ///< a key of the case file, or a part of one
inline constexpr const char* count = "N";
inline constexpr const char* time = "TIME";
inline constexpr const char* name = "NAME";
}  // namespace value_kind

/// A word that an option takes, and what it stands for.
struct OptionWord {
    std::string word;
    std::string meaning;
};

/// Adds an option that takes one of `words`, which its help lists before `meaning`. Another word is
/// refused, and the nearest told.
CLI::Option* add_choice(CLI::App& verb, const std::string& name, std::string& value,
                        const std::vector<OptionWord>& words, const std::string& meaning = {});

/// The kind of an option's value, or its words with bars between; empty for a flag.
std::string kind_of_value(const CLI::Option& option);

}  // namespace tt
