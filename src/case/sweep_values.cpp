#include "case/sweep_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/letter.hpp"
#include "base/units.hpp"

namespace tt {
namespace {

constexpr std::string_view how_to_write =
    "write a list, as in 0.1, 0.2, 0.5, or a range FROM:TO:STEP, as in 0.1:1:0.1";

/// "50 /s": a number and what stands behind it. Nothing if it does not begin with a number.
struct NumberText {
    double number = 0.0;
    std::string unit;
};
std::optional<NumberText> number_in(std::string_view text) {
    const std::size_t length = number_length(text);
    if (length == 0) return std::nullopt;
    try {
        return NumberText{parse_measure(text.substr(0, length)).si,
                          std::string(trimmed(text.substr(length)))};
    } catch (const UnitError&) {
        return std::nullopt;
    }
}

std::string with_unit(double number, const std::string& unit) {
    const std::string text = to_text(number);
    return unit.empty() ? text : text + " " + unit;
}

/// To twelve digits: 0.1 + 2 · 0.1 is 0.3.
double decimal(double number) { return parse_measure(fmt::format("{:.12g}", number)).si; }

constexpr double most_values = 1e4;

/// A value as text. A number without a unit takes that of the last of its list.
struct Item {
    std::string text;
    bool bare = false;
};

/// FROM:TO:STEP, or FROM:TO:*FACTOR.
class RangeText {
public:
    explicit RangeText(std::string_view text) : parts_(cut(text, ':')) {}

    bool is_range() const { return parts_.size() > 1 && number_in(parts_[0]).has_value(); }
    std::vector<Item> items();

private:
    double value(double k) const {
        return decimal(factor_ ? from_ * std::pow(step_, k) : from_ + k * step_);
    }
    void read();
    double steps() const;
    std::string step_text() const {
        return fmt::format("{}{}", factor_ ? "*" : "", to_text(step_));
    }

    std::vector<std::string_view> parts_;
    double from_ = 0.0, to_ = 0.0, step_ = 0.0;
    std::string unit_;
    bool factor_ = false;
};

void RangeText::read() {
    if (parts_.size() != 3) throw SweepError(std::string(how_to_write));
    factor_ = parts_[2].starts_with('*');
    if (factor_) parts_[2] = trimmed(parts_[2].substr(1));
    std::vector<NumberText> numbers;
    for (const std::string_view part : parts_) {
        const auto number = number_in(part);
        if (!number)
            throw SweepError(fmt::format("{} is not a number; {}", readable(part), how_to_write));
        numbers.push_back(*number);
    }
    from_ = numbers[0].number, to_ = numbers[1].number, step_ = numbers[2].number;
    unit_ = numbers[2].unit.empty() ? numbers[1].unit : numbers[2].unit;
    for (const NumberText& each : numbers)
        if (!each.unit.empty() && each.unit != unit_)
            throw SweepError(
                fmt::format("the three numbers of a range are of one unit; write {}:{}:{} {}",
                            to_text(from_), to_text(to_), step_text(), unit_));
}

/// How many lead from one end to the other.
double RangeText::steps() const {
    const bool can = factor_ ? step_ > 0.0 && step_ != 1.0 && from_ * to_ > 0.0 : step_ != 0.0;
    const double steps = factor_ ? std::log(to_ / from_) / std::log(step_) : (to_ - from_) / step_;
    if (!can || !(steps >= 0.0))
        throw SweepError(fmt::format("no steps of {} lead from {} to {}; {}", step_text(),
                                     to_text(from_), to_text(to_), how_to_write));
    if (steps >= most_values)
        throw SweepError(fmt::format("a range of {:.3g} values; at most {:.0f} will do",
                                     steps + 1.0, most_values));
    if (std::abs(steps - std::round(steps)) > 1e-6)
        throw SweepError(fmt::format("the steps of {} do not end at {}; write {} or {} for it",
                                     step_text(), to_text(to_), to_text(value(std::floor(steps))),
                                     to_text(value(std::ceil(steps)))));
    return std::round(steps);
}

std::vector<Item> RangeText::items() {
    read();
    std::vector<Item> items;
    const double last = steps();
    for (double k = 0.0; k <= last; ++k)
        items.push_back({with_unit(k == last ? to_ : value(k), unit_), unit_.empty()});
    return items;
}

std::string with_common_unit(const Item& item, const std::string& unit) {
    return item.bare && !unit.empty() ? fmt::format("{} {}", item.text, unit) : item.text;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// `text` cut at `separator`, but not within quotes or brackets.
std::vector<std::string_view> cut(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    int depth = 0;
    char quote = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == ']') {
            depth += c == '[' ? 1 : -1;
        } else if (c == separator && depth <= 0) {
            parts.push_back(trimmed(text.substr(begin, k - begin)));
            begin = k + 1;
        }
    }
    parts.push_back(trimmed(text.substr(begin)));
    return parts;
}

std::vector<std::string> listed_settings(std::string_view text) {
    std::vector<Item> items;
    for (const std::string_view part : cut(text, ',')) {
        if (part.empty()) throw SweepError(fmt::format("a value is missing; {}", how_to_write));
        RangeText range(part);
        if (range.is_range()) {
            for (Item& item : range.items()) items.push_back(std::move(item));
        } else {
            const auto number = number_in(part);
            items.push_back({std::string(part), number && number->unit.empty()});
        }
    }
    const auto last = number_in(items.back().text);
    std::vector<std::string> settings;
    for (const Item& item : items)
        settings.push_back(with_common_unit(item, last ? last->unit : std::string{}));
    return settings;
}

}  // namespace tt
