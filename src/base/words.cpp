#include "base/words.hpp"

#include <algorithm>
#include <cctype>

namespace tt {

namespace {

/// Up to the first space outside double quotes: "4 um" stays together.
std::string_view first_word(std::string_view text) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') quoted = !quoted;
        if (text[i] == ' ' && !quoted) return text.substr(0, i);
    }
    return text;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

std::optional<std::string_view> closest(std::string_view word,
                                        const std::vector<std::string_view>& candidates) {
    if (word.size() < 2 || word.size() > 60)
        return std::nullopt;  // too short to tell, or no word of ours
    std::optional<std::string_view> best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view candidate : candidates) {
        std::size_t distance = edit_distance(word, candidate);
        const bool part = word.size() >= 3 && candidate.size() >= word.size() &&
                          (candidate.substr(0, word.size()) == word ||
                           candidate.substr(candidate.size() - word.size()) == word);
        if (part) distance = std::min<std::size_t>(distance, 1);
        if (distance >= best_distance) continue;
        best = candidate;
        best_distance = distance;
    }
    return best;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

std::string shell_quoted(std::string_view text) {
    std::string word = "'";
    for (const char c : text) {
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    }
    word += '\'';
    return word;
}

std::string shell_word(const std::string& text) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view("/._-+,").find(c) != std::string_view::npos;
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), plain) ? text
                                                                         : shell_quoted(text);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
    std::string result;
    std::size_t column = 0;
    while (!text.empty()) {
        const std::string_view word = first_word(text);
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        if (word.empty()) continue;
        if (column > indent && column + 1 + word.size() > width) {
            result += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (!result.empty()) {
            result += ' ';
            ++column;
        } else {
            column = indent;
        }
        result += word;
        column += word.size();
    }
    return result;
}

std::string wrapped_lines(std::string_view text, std::size_t width, std::size_t indent) {
    std::string result;
    for (const std::string_view line : split(text, '\n')) {
        if (!result.empty()) result += '\n';
        result += line.size() > width ? wrapped(line, width, indent) : line;
    }
    return result;
}

bool has_open_quote(std::string_view line) {
    return std::count(line.begin(), line.end(), '"') % 2 == 1;
}

std::string with_short_words(std::string_view text) {
    constexpr std::size_t longest = 255, kept = 60;  // at either end
    const auto inside_letter = [](char c) { return (c & 0xC0) == 0x80; };
    std::string result;
    while (!text.empty()) {
        const std::size_t size = std::min(text.find_first_of(" \n"), text.size());
        std::string_view word = text.substr(0, size);
        if (size > longest) {
            std::size_t head = kept, tail = size - kept;
            while (head > 0 && inside_letter(word[head])) --head;
            while (tail < size && inside_letter(word[tail])) ++tail;
            result.append(word.substr(0, head)).append(" ... ");
            word.remove_prefix(tail);
        }
        result += word;
        const bool more = size < text.size();
        if (more) result += text[size];
        text.remove_prefix(size + (more ? 1 : 0));
    }
    return result;
}

}  // namespace tt
