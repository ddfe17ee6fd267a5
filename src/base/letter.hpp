#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tt {

/// A letter of a text in UTF-8.
struct Letter {
    std::uint32_t code = 0;  ///< 0: not UTF-8
    std::size_t bytes = 1;
};

/// The letter at the start of `text`, which is not empty. Overlong forms, surrogates and stray
/// bytes have code 0.
Letter first_letter(std::string_view text);

/// What to write in a number or a unit instead of this letter, which people and word processors put
/// there; empty if none comes to mind.
std::string_view instead_of(std::uint32_t code);

/// `text` as a message may show it: whole letters, '?' for what cannot be shown, and at most `most`
/// letters.
std::string readable(std::string_view text, std::size_t most = 80);

}  // namespace tt
