#include "io/point_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/words.hpp"

namespace tt {
namespace {

constexpr std::size_t faults_told = 10;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The words of a line, parted by blanks and, if so asked, commas; quotes around them fall away.
std::vector<std::string_view> words_of(std::string_view line, std::string_view separators) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = line.find_first_not_of(separators);
        if (begin == std::string_view::npos) return words;
        line.remove_prefix(begin);
        std::string_view word = line.substr(0, line.find_first_of(separators));
        line.remove_prefix(word.size());
        if (word.size() >= 2 && word.front() == '"' && word.back() == '"')
            word = word.substr(1, word.size() - 2);
        words.push_back(word);
    }
}

std::optional<double> number(std::string_view word) {
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0.0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// "4,15": digits on both sides of its one comma.
bool has_decimal_comma(std::string_view word) {
    if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
    const std::size_t comma = word.find(',');
    if (comma == 0 || comma == std::string_view::npos || comma + 1 == word.size()) return false;
    word.remove_suffix(word.size() - std::min(word.size(), word.find_first_of("eE")));
    return std::all_of(word.begin(), word.end(), [](char c) { return is_digit(c) || c == ','; }) &&
           std::count(word.begin(), word.end(), ',') == 1;
}

bool any_decimal_comma(const std::vector<std::string_view>& words) {
    return std::any_of(words.begin(), words.end(), has_decimal_comma);
}

/// "4,15,0,2": two numbers with decimal commas and a comma between them.
bool is_pair_in_four(std::string_view line) {
    const auto words = words_of(line, ",");
    return words.size() == 4 && std::all_of(words.begin(), words.end(), [](std::string_view word) {
               if (word.substr(0, 1) == "-") word.remove_prefix(1);
               return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
           });
}

/// The part of a heading's word that names a column: "Y" of "Y [um]".
bool names(std::string_view word, std::initializer_list<std::string_view> candidates) {
    std::string lower;
    for (const char c : word) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return std::find(candidates.begin(), candidates.end(), lower) != candidates.end();
}

/// Takes "(um)" or "[um]" out of a heading; the unit is the first of them.
std::string without_units(std::string_view heading, std::string& unit) {
    std::string rest;
    for (std::size_t k = 0; k < heading.size(); ++k) {
        const char close = heading[k] == '(' ? ')' : heading[k] == '[' ? ']' : '\0';
        const std::size_t end = close != '\0' ? heading.find(close, k) : std::string_view::npos;
        if (end == std::string_view::npos) {
            rest += heading[k];
            continue;
        }
        if (unit.empty()) unit = heading.substr(k + 1, end - k - 1);
        k = end;
    }
    return rest;
}

/// Reads line by line and gathers faults.
class PointReader {
public:
    explicit PointReader(const std::string& name) : name_(name) {}

    void read_line(std::string_view line, int at) {
        line = line.substr(0, line.find('#'));
        const auto words = words_of(line, ", \t");
        if (words.empty()) return;
        refuse_other_kinds(line, at);
        if (has_open_quote(line))
            return tell(at, "a quote (\") is left open; close it, or leave it out");
        if (list_.points.empty() && columns_ == 0 && faults_.empty() && is_heading(words))
            return read_heading(line);
        read_pair(words, at);
    }

    PointList finish() {
        if (untold_ > 0)
            faults_.push_back({name_, 0, 0, fmt::format("and {} more lines like these", untold_)});
        if (!faults_.empty()) throw CaseError(faults_);
        return std::move(list_);
    }

private:
    [[noreturn]] void refuse(int at, std::string message) const {
        throw CaseError({{name_, at, at > 0 ? 1 : 0, std::move(message)}});
    }
    void tell(int at, std::string message) {
        if (faults_.size() < faults_told)
            faults_.push_back({name_, at, 1, std::move(message)});
        else
            ++untold_;
    }

    void refuse_other_kinds(std::string_view line, int at) const {
        const bool semicolons = line.find(';') != std::string_view::npos;
        const bool commas = any_decimal_comma(words_of(line, "; \t")) &&
                            (semicolons || words_of(line, " \t").size() > 1);
        if (semicolons)
            refuse(at, fmt::format("the columns are parted by semicolons{}; write x,y with a comma "
                                   "between the numbers and points in them, as in 4.15,0.2",
                                   commas ? " and the numbers have decimal commas" : ""));
        if (commas || (!named_ && is_pair_in_four(line)))
            refuse(at,
                   "the numbers have decimal commas; write x,y with points in the numbers and "
                   "a comma between them, as in 4.15,0.2");
    }

    static bool is_heading(const std::vector<std::string_view>& words) {
        return std::none_of(words.begin(), words.end(),
                            [](std::string_view word) { return number(word).has_value(); });
    }

    void read_heading(std::string_view line) {
        const std::string text = without_units(line, list_.unit);
        const auto words = words_of(text, ", \t");
        columns_ = words.size();
        const auto column = [&](std::initializer_list<std::string_view> candidates) {
            const auto at = std::find_if(words.begin(), words.end(), [&](std::string_view word) {
                return names(word, candidates);
            });
            return static_cast<std::size_t>(at - words.begin());
        };
        const std::size_t x = column({"x", "col", "column"}), y = column({"y", "row"});
        if (x == columns_ || y == columns_) return;
        x_ = x;
        y_ = y;
        named_ = true;
    }

    void read_pair(const std::vector<std::string_view>& words, int at) {
        // Tables number their rows in a column that has no name.
        const std::size_t shift = named_ && words.size() == columns_ + 1 ? 1 : 0;
        const std::size_t wanted = named_ ? columns_ + shift : 2;
        if (words.size() != wanted)
            return tell(at,
                        fmt::format("expected {}, found {} word{}",
                                    named_ ? fmt::format("the {} columns of the heading", columns_)
                                           : std::string("two numbers: x, y in um"),
                                    words.size(), words.size() == 1 ? "" : "s"));
        Vec2 point;
        for (const auto& [column, value] : {std::pair{x_, &point.x}, std::pair{y_, &point.y}}) {
            const std::string_view word = words[column + shift];
            const auto read = number(word);
            if (!read)
                return tell(at, fmt::format("'{}' is no number; expected two: x, y in um",
                                            word.substr(0, 40)));
            if (!(std::abs(*read) <= largest_coordinate))
                return tell(at, fmt::format("{} is no coordinate of a cell", word.substr(0, 40)));
            *value = *read;
        }
        if (list_.points.size() == most_points)
            refuse(at, fmt::format("an outline has at most {} points", most_points));
        list_.points.push_back(point);
        list_.lines.push_back(at);
    }

    const std::string& name_;
    PointList list_;
    std::vector<Fault> faults_;
    int untold_ = 0;
    std::size_t columns_ = 0;  ///< of the heading
    std::size_t x_ = 0, y_ = 1;
    bool named_ = false;  ///< the heading names x and y
};

/// Takes a byte order mark off. Throws CaseError for what is no text in UTF-8.
std::string_view without_mark(std::string_view text, const std::string& name) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") return text.substr(3);
    if (text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF")
        throw CaseError({{name, 0, 0, "the text is in UTF-16; save it as UTF-8 or plain ASCII"}});
    if (text.find('\0') != std::string_view::npos)
        throw CaseError({{name, 0, 0, "this is no text; expected x,y in um, one point a line"}});
    return text;
}

}  // namespace

PointList parse_points(std::string_view text, const std::string& name, int first_line) {
    text = without_mark(text, name);
    PointReader reader(name);
    for (int at = first_line; !text.empty(); ++at) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        reader.read_line(text.substr(0, end), at);
        const bool pair = text.substr(end, 2) == "\r\n";
        text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
    }
    return reader.finish();
}

}  // namespace tt
