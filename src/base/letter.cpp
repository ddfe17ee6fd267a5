#include "base/letter.hpp"

#include <array>

namespace tt {
namespace {

struct Replacement {
    std::uint32_t code;
    std::string_view write;
};
constexpr std::array replacements{
    Replacement{0xb2, "'^2'"},
    Replacement{0xb3, "'^3'"},
    Replacement{0xb7, "a space or '*'"},
    Replacement{0x22c5, "a space or '*'"},
    Replacement{0xd7, "'*'"},
    Replacement{0xb0, "' deg'"},
    Replacement{0xc5, "nm; 1 angstrom is 0.1 nm"},
    Replacement{0x212b, "nm; 1 angstrom is 0.1 nm"},
    Replacement{0x2212, "'-'"},
    Replacement{0x2013, "'-'"},
    Replacement{0x207b, "'^-1' or '/'"},
    Replacement{0x201c, "'\"'"},
    Replacement{0x201d, "'\"'"},
    Replacement{0x2018, "'"},
    Replacement{0x2019, "'"},
    Replacement{0xa0, "a plain space"},
    Replacement{0x202f, "a plain space"},
    Replacement{0x2009, "a plain space"},
};

}  // namespace

Letter first_letter(std::string_view text) {
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

std::string readable(std::string_view text, std::size_t most) {
    std::string result;
    for (std::size_t count = 0; !text.empty(); ++count) {
        if (count == most) return result + "...";
        const Letter letter = first_letter(text);
        const bool control = letter.code < 0x20 || (letter.code >= 0x7f && letter.code < 0xa0);
        result += control ? "?" : text.substr(0, letter.bytes);
        text.remove_prefix(letter.bytes);
    }
    return result;
}

std::string_view instead_of(std::uint32_t code) {
    for (const Replacement& r : replacements)
        if (r.code == code) return r.write;
    return {};
}

}  // namespace tt
