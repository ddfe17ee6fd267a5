#include "io/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/letter.hpp"
#include "io/toml_scan.hpp"

namespace tt {
namespace {

/// toml++ 3.3.0 asserts on texts such as `[@ase]`; an exception takes the place of abort(). With
/// NDEBUG it would drop its asserts, and read memory that is not its own.
[[noreturn]] void parser_gave_up() { throw std::runtime_error("this line cannot be read"); }

}  // namespace
}  // namespace tt

#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? static_cast<void>(0) : ::tt::parser_gave_up())
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace tt {
namespace {

TomlNode converted(const toml::node& node);

void convert_table(const toml::table& table, TomlNode& result) {
    result.kind = TomlNode::Kind::table;
    for (const auto& [key, value] : table) {
        TomlEntry entry;
        entry.key = std::string(key.str());
        entry.line = static_cast<int>(key.source().begin.line);
        entry.column = static_cast<int>(key.source().begin.column);
        entry.value = converted(value);
        result.entries.push_back(std::move(entry));
    }
    std::sort(result.entries.begin(), result.entries.end(),
              [](const TomlEntry& a, const TomlEntry& b) {
                  return std::pair(a.line, a.column) < std::pair(b.line, b.column);
              });
}

TomlNode converted(const toml::node& node) {
    using Kind = TomlNode::Kind;
    TomlNode result;
    result.line = static_cast<int>(node.source().begin.line);
    result.column = static_cast<int>(node.source().begin.column);
    if (const auto* table = node.as_table()) {
        convert_table(*table, result);
    } else if (const auto* array = node.as_array()) {
        result.kind = Kind::array;
        for (const toml::node& item : *array) result.items.push_back(converted(item));
    } else if (const auto* text = node.as_string()) {
        result.kind = Kind::string;
        result.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        result.kind = Kind::integer;
        result.integer = integer->get();
    } else if (const auto* real = node.as_floating_point()) {
        result.kind = Kind::real;
        result.real = real->get();
    } else if (const auto* boolean = node.as_boolean()) {
        result.kind = Kind::boolean;
        result.boolean = boolean->get();
    } else {
        result.kind = Kind::date;
    }
    return result;
}

/// The first thing wrong, and where; line 0 where the parser cannot tell.
struct Attempt {
    std::optional<TomlNode> root;
    Fault fault;
};

Attempt attempt(const std::string& text, const std::string& name) {
    Attempt result;
    try {
        TomlNode root;
        convert_table(toml::parse(text), root);
        result.root = std::move(root);
    } catch (const toml::parse_error& error) {
        const auto& where = error.source().begin;
        result.fault = {name, static_cast<int>(where.line), static_cast<int>(where.column),
                        std::string(error.description())};
    } catch (const std::exception& error) {
        result.fault = {name, 0, 0, error.what()};
    }
    return result;
}

/// Begin and end of a line, counted from 1.
std::pair<std::size_t, std::size_t> line_bounds(const std::string& text, int line) {
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) return {text.size(), text.size()};
        begin = end + 1;
    }
    return {begin, std::min(text.find('\n', begin), text.size())};
}

/// The parser's asserts carry no position: the first line up to which the text is refused.
int first_refused_line(const std::string& text) {
    const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
    int good = 0;
    int bad = lines;
    while (bad - good > 1) {
        const int middle = good + (bad - good) / 2;
        const Attempt head = attempt(text.substr(0, line_bounds(text, middle).second), "");
        (head.root ? good : bad) = middle;
    }
    return bad;
}

/// What the parser says, in the words of this program where it can be said better.
std::string reworded(const std::string& message, std::string_view line) {
    if (message.find("redefine existing") != std::string::npos) {
        const std::size_t quote = message.find('\'');
        const std::size_t end = message.find('\'', quote + 1);
        if (quote != std::string::npos && end != std::string::npos)
            return fmt::format("{} is written twice", message.substr(quote, end - quote + 1));
    }
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos && line.find_first_of("\"'[{") == std::string_view::npos) {
        std::size_t value = line.find_first_not_of(" \t", equals + 1);
        std::size_t end = std::min(line.find('#'), line.size());
        while (end > 0 && (line[end - 1] == ' ' || line[end - 1] == '\t' || line[end - 1] == '\r'))
            --end;
        if (value < end)
            return fmt::format("this value needs quotes: write \"{}\"",
                               line.substr(value, end - value));
    }
    const std::size_t colon = message.find(": ");
    return "not TOML: " + (colon == std::string::npos ? message : message.substr(colon + 2));
}

}  // namespace

const TomlEntry* TomlNode::find(std::string_view key) const {
    for (const TomlEntry& entry : entries)
        if (entry.key == key) return &entry;
    return nullptr;
}

TomlEntry* TomlNode::find(std::string_view key) {
    return const_cast<TomlEntry*>(std::as_const(*this).find(key));
}

TomlText parse_toml(std::string_view given, const std::string& name) {
    TomlText result;
    AsciiText ascii = to_ascii(given, name);
    result.faults = std::move(ascii.faults);
    if (!result.faults.empty()) return result;
    constexpr int most_faults = 10;
    int previous = 0;
    for (int i = 0; i < most_faults; ++i) {
        Attempt a = attempt(ascii.text, name);
        if (a.root) {
            result.root = std::move(*a.root);
            return result;
        }
        if (a.fault.line == 0) a.fault.line = first_refused_line(ascii.text), a.fault.column = 1;
        const auto [begin, end] = line_bounds(ascii.text, a.fault.line);
        const std::string line = ascii.text.substr(begin, end - begin);
        if (a.fault.line <= previous || line.find_first_not_of(" \t\r") == std::string::npos) {
            // The line is already out, or says nothing: what is open began further up and cannot be
            // mended here.
            if (result.faults.empty())
                result.faults.push_back(
                    {name, a.fault.line, a.fault.column, reworded(a.fault.message, line)});
            return result;
        }
        a.fault.message = reworded(a.fault.message, line);
        result.faults.push_back(a.fault);
        previous = a.fault.line;
        // Without its header the keys below it would be taken for those of the table above.
        if (line[line.find_first_not_of(" \t")] == '[') return result;
        ascii.text.replace(begin, end - begin, "");
    }
    return result;
}

/// Of a value that is quoted and yet no TOML.
std::string without_quotes(const std::string& text) {
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

TomlNode parse_toml_value(const std::string& text) {
    const AsciiText ascii = to_ascii("x = " + text, "");
    TomlNode as_string;
    as_string.kind = TomlNode::Kind::string;
    as_string.text = ascii.faults.empty() ? ascii.text.substr(4) : without_quotes(text);
    if (!ascii.faults.empty() || text.find('\n') != std::string::npos) return as_string;
    Attempt a = attempt(ascii.text, "");
    if (!a.root || a.root->entries.size() != 1 || a.root->entries[0].key != "x") return as_string;
    TomlNode value = std::move(a.root->entries[0].value);
    if (value.kind == TomlNode::Kind::date || value.kind == TomlNode::Kind::table) return as_string;
    // A number that is wanted as a word, as in --set name=7, is taken as written.
    if (value.kind != TomlNode::Kind::string) value.text = as_string.text;
    return value;
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (letter.code == '"' || letter.code == '\\') result += '\\';
        const bool control = letter.code < 0x20 && (letter.code != 0 || text.front() == '\0');
        if (letter.code > 0xffff)
            result += fmt::format("\\U{:08x}", letter.code);
        else if (letter.code > 0x7e || control)
            result += fmt::format("\\u{:04x}", letter.code);
        else
            result += text.substr(0, letter.bytes);
        text.remove_prefix(letter.bytes);
    }
    return result + "\"";
}

}  // namespace tt
