#include "io/toml_scan.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "base/letter.hpp"

namespace tt {
namespace {

constexpr std::size_t size_limit = std::size_t{1} << 20;

std::string refusal(const Letter& letter, std::string_view bytes) {
    if (letter.code == 0) return "this byte is not UTF-8; save the file as UTF-8";
    if (letter.code < 0x20 || letter.code == 0x7f)
        return fmt::format("control character 0x{:02x} in the text", letter.code);
    if (const std::string_view write = instead_of(letter.code); !write.empty())
        return fmt::format("'{}' is not ASCII; write {}", bytes, write);
    return fmt::format("'{}' is not ASCII; such letters may stand in comments only", bytes);
}

/// Follows strings and comments just closely enough to know which of them a letter stands in.
class Context {
public:
    /// Goes past the ASCII letter at the start of `rest`; returns how many letters belong together.
    std::size_t pass(std::string_view rest) {
        const char c = rest[0];
        if (in_comment_) {
            in_comment_ = c != '\n';
            return 1;
        }
        if (quote_ == 0) return begin(rest);
        if (c == '\\' && quote_ == '"' && rest.size() > 1 && rest[1] >= ' ' && rest[1] < 0x7f)
            return 2;
        if (c == '\n' && length_ == 1) quote_ = 0;  // not closed: the parser tells
        if (c != quote_ || rest.substr(0, length_) != std::string(length_, quote_)) return 1;
        quote_ = 0;
        return length_;
    }
    bool in_comment() const { return in_comment_; }
    /// In neither a string nor a comment.
    bool in_syntax() const { return quote_ == 0 && !in_comment_; }

private:
    std::size_t begin(std::string_view rest) {
        const char c = rest[0];
        in_comment_ = c == '#';
        if (c != '"' && c != '\'') return 1;
        quote_ = c;
        length_ = rest.substr(0, 3) == std::string(3, c) ? 3 : 1;
        return length_;
    }

    bool in_comment_ = false;
    char quote_ = 0;
    std::size_t length_ = 1;
};

/// How deep a text nests. The parser follows nesting by recursion, and keys without any bound.
class Nesting {
public:
    /// Goes past a letter outside of strings and comments; whether that is still of use.
    bool pass(char c) {
        if (c == '.')
            ++dots_;
        else if (c == '=' || c == ',' || c == '\n' || c == '[' || c == '{')
            dots_ = 0;
        if (c == '[' || c == '{')
            ++brackets_;
        else if ((c == ']' || c == '}') && brackets_ > 0)
            --brackets_;
        return dots_ <= deepest && brackets_ <= deepest;
    }
    static constexpr int deepest = 16;

private:
    int dots_ = 0;  ///< of the key at hand
    int brackets_ = 0;
};

}  // namespace

AsciiText to_ascii(std::string_view text, const std::string& name) {
    AsciiText result;
    if (text.size() > size_limit) {
        result.faults.push_back(
            {name, 1, 1,
             fmt::format("has {} MB; a case file has a few kB", text.size() / 1000000)});
        return result;
    }
    if (text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff") {
        result.faults.push_back({name, 1, 1, "the file is UTF-16; save it as UTF-8"});
        return result;
    }
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    Context context;
    Nesting nesting;
    int line = 1;
    int column = 1;
    int told_line = 0;  // one fault a line is enough
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        const bool plain = (letter.code >= 0x20 && letter.code < 0x7f) || letter.code == '\n' ||
                           letter.code == '\t' ||
                           (letter.code == '\r' && text.substr(0, 2) == "\r\n");
        if (plain) {
            if (context.in_syntax() && !nesting.pass(text.front())) {
                result.faults.push_back(
                    {name, line, column,
                     fmt::format("keys or brackets nest deeper than {} levels", Nesting::deepest)});
                return result;
            }
            const std::size_t count = context.pass(text);
            result.text += text.substr(0, count);
            column = letter.code == '\n' ? 1 : column + static_cast<int>(count);
            line += letter.code == '\n' ? 1 : 0;
            text.remove_prefix(count);
            continue;
        }
        const bool micro = letter.code == 0xb5 || letter.code == 0x3bc;
        if (!micro && !context.in_comment() && told_line != line) {
            result.faults.push_back(
                {name, line, column, refusal(letter, text.substr(0, letter.bytes))});
            told_line = line;
        }
        result.text += micro ? 'u' : '?';
        ++column;
        text.remove_prefix(letter.bytes);
    }
    return result;
}

}  // namespace tt
