#include "io/toml_scan.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace tt {
namespace {

constexpr std::size_t size_limit = std::size_t{1} << 20;

struct Letter {
    std::uint32_t code = 0;  ///< 0: not UTF-8
    std::size_t bytes = 1;
};

/// The letter at the start of `text`; overlong forms, surrogates and stray bytes have code 0.
Letter decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
    if (code < smallest[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
    return {code, bytes};
}

struct Advice {
    std::uint32_t code;
    std::string_view write;
};
constexpr std::array advices{
    Advice{0xb2, "'^2'"},
    Advice{0xb3, "'^3'"},
    Advice{0xb7, "a space or '*'"},
    Advice{0x22c5, "a space or '*'"},
    Advice{0xd7, "'*'"},
    Advice{0xb0, "' deg'"},
    Advice{0x2212, "'-'"},
    Advice{0x2013, "'-'"},
    Advice{0x207b, "'^-1' or '/'"},
    Advice{0x201c, "'\"'"},
    Advice{0x201d, "'\"'"},
    Advice{0x2018, "'"},
    Advice{0x2019, "'"},
    Advice{0xa0, "a plain space"},
    Advice{0x202f, "a plain space"},
    Advice{0x2009, "a plain space"},
};

std::string refusal(const Letter& letter, std::string_view bytes) {
    if (letter.code == 0) return "this byte is not UTF-8; save the file as UTF-8";
    if (letter.code < 0x20 || letter.code == 0x7f)
        return fmt::format("control character 0x{:02x} in the text", letter.code);
    for (const Advice& a : advices)
        if (a.code == letter.code)
            return fmt::format("'{}' is not ASCII; write {}", bytes, a.write);
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
    int line = 1;
    int column = 1;
    int told_line = 0;  // one fault a line is enough
    while (!text.empty()) {
        const Letter letter = decode(text);
        const bool plain = (letter.code >= 0x20 && letter.code < 0x7f) || letter.code == '\n' ||
                           letter.code == '\t' ||
                           (letter.code == '\r' && text.substr(0, 2) == "\r\n");
        if (plain) {
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
