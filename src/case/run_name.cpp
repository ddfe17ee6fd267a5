#include "case/run_name.hpp"

#include <fmt/format.h>

#include "io/toml.hpp"

namespace tt {
namespace {

/// With ".1" or ".tmp" behind it the name must still be one of a file: 255 bytes.
constexpr std::size_t longest = 100;

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool may_stand(char c) { return c >= ' ' && c < 0x7f && c != '/' && c != '\\'; }

}  // namespace

std::optional<std::string> fault_of_name(std::string_view name) {
    if (name.empty()) return "name is empty; write name = \"channel-500\", or leave it out";
    if (name.size() > longest)
        return fmt::format("name has {} letters; at most {} will do", name.size(), longest);
    for (const char c : name)
        if (!may_stand(c))
            return fmt::format(
                "name may hold letters of ASCII, digits, spaces and marks, but no '/' and no '\\'; "
                "write name = {}",
                toml_string(name_from(name)));
    if (name_from(name) == name) return std::nullopt;
    return fmt::format(
        "name must begin with a letter, a digit or '_', end without a space and hold no '..'; "
        "write "
        "name = {}",
        toml_string(name_from(name)));
}

std::string name_from(std::string_view text) {
    std::string name;
    for (const char c : text.substr(0, longest)) {
        const bool twice = c == '.' && !name.empty() && name.back() == '.';
        const bool foreign =
            (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // a letter's later byte
        if (!foreign) name += may_stand(c) && !twice ? c : '_';
    }
    if (name.empty() || !(is_letter_or_digit(name.front()) || name.front() == '_'))
        name.insert(0, "run");
    if (name != text && name.find_first_not_of('_') == std::string::npos) name = "run";
    if (name.size() > longest) name.resize(longest);
    if (name.back() == ' ') name.back() = '_';
    return name;
}

}  // namespace tt
