#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tt {

/// How many letters must be added, dropped, changed or swapped with their neighbour to make `b` of
/// `a` (Damerau–Levenshtein, optimal alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` was probably meant to be: at most a third of its letters wrong, or one
/// that begins or ends with it. Nothing if none is near.
std::optional<std::string_view> closest(std::string_view word,
                                        const std::vector<std::string_view>& candidates);

/// "a|b|c" cut at the bars.
std::vector<std::string_view> split(std::string_view text, char separator);

/// `text` as one word of a shell, within single quotes.
std::string shell_quoted(std::string_view text);

/// The same, quoted only where it must be.
std::string shell_word(const std::string& text);

/// Whether a quote (") is opened in a line and not closed.
bool has_open_quote(std::string_view line);

/// `text` with the middle left out of each word that is longer than a name of a file may be, 255
/// bytes.
std::string with_short_words(std::string_view text);

/// `text` broken at spaces, but not inside quotes, into lines of at most `width` letters; lines
/// after the first begin with `indent` spaces.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

/// `text` with each of its lines that is longer than `width` wrapped.
std::string wrapped_lines(std::string_view text, std::size_t width, std::size_t indent = 0);

}  // namespace tt
