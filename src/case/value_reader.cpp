#include "case/value_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/letter.hpp"
#include "base/words.hpp"
#include "case/field_types.hpp"

namespace tt {
namespace {

using Kind = TomlNode::Kind;

/// How the example stands in the file: quantities and words in quotes.
std::string written_example(const FieldText& field) {
    if (field.example.empty()) return toml_string(split(field.choices, '|').front());
    const bool plain =
        field.example.front() == '[' || number_length(field.example) == field.example.size();
    return plain ? std::string(field.example) : toml_string(field.example);
}

std::string range_text(const Range& range, std::string_view unit) {
    const auto text = [&](double v) { return to_text(v, v == 0.0 ? std::string_view{} : unit); };
    if (std::isinf(range.high))
        return fmt::format("must be {} {}", range.low_open ? "more than" : "at least",
                           text(range.low));
    if (range.low == range.high) return fmt::format("must be {}", text(range.low));
    return fmt::format("must be {} {} and at most {}", range.low_open ? "more than" : "at least",
                       text(range.low), text(range.high));
}

/// A bare number for a quantity: taken in SI if that is nearer to the usual size, else in the
/// customary unit.
std::string with_unit(double number, Dimension dimension, std::string_view example) {
    const std::string_view unit = unit_of(example);
    const double usual = parse_measure(example).si;
    const double factor = parse_measure(fmt::format("1 {}", unit)).si;
    const auto far = [&](double si) { return std::abs(std::log10(std::abs(si) / usual)); };
    const bool in_si = number != 0.0 && std::isfinite(number) && far(number) < far(number * factor);
    return in_si ? fmt::format("{} {}", to_text(number), si_unit(dimension))
                 : fmt::format("{} {}", to_text(number), unit);
}

std::string_view first_example(std::string_view example) {
    const std::size_t quote = example.find('"');
    return quote == std::string_view::npos ? example
                                           : split(example.substr(quote + 1), '"').front();
}

std::string missing_unit(const FieldText& field, const std::string& shown_text, double bare,
                         Dimension dimension) {
    const std::string_view example = first_example(field.example);
    const std::string meant = with_unit(bare, dimension, example);
    const bool possible = field.range.contains(parse_measure(meant).si);
    return fmt::format("{} = {} has no unit; write {} = {}", field.key, shown_text, field.key,
                       toml_string(possible ? meant : std::string(example)));
}

bool meant_percent(const TomlNode& node, const FieldText& field, double number) {
    return node.kind != Kind::string && unit_of(field.example) == "%" &&
           field.range.contains(number / 100.0);
}

}  // namespace

std::string ValueReader::shown(const TomlNode& node) {
    switch (node.kind) {
        case Kind::string:
            return fmt::format("\"{}\"", readable(node.text));
        case Kind::integer:
            return fmt::format("{}", node.integer);
        case Kind::real:
            return std::isfinite(node.real) ? to_text(node.real) : fmt::format("{}", node.real);
        case Kind::boolean:
            return node.boolean ? "true" : "false";
        case Kind::date:
            return "a date";
        case Kind::array:
            return "[...]";
        case Kind::table:
            return "a table";
    }
    return {};
}

void ValueReader::tell(const TomlEntry& entry, const TomlNode& value, std::string message) {
    faults.push_back(place(entry, value.line, value.column));
    faults.back().message = std::move(message);
}

void ValueReader::tell_key(const TomlEntry& entry, std::string message) {
    faults.push_back(place(entry, entry.line, entry.column));
    faults.back().message = std::move(message);
}

void ValueReader::read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                             double& result) {
    std::optional<double> number;
    if (node.kind == Kind::integer)
        number = static_cast<double>(node.integer);
    else if (node.kind == Kind::real)
        number = node.real;
    else if (node.kind == Kind::string)
        number = measure(entry, node, field, Dimension{});
    else
        tell(entry, node,
             fmt::format("{} = {} must be a number, as in {}", field.key, shown(node),
                         written_example(field)));
    if (!number) return;
    if (node.kind == Kind::string || in_range(entry, node, field, *number)) result = *number;
}

void ValueReader::read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                             std::int64_t& result) {
    if (node.kind != Kind::integer)
        return tell(entry, node,
                    fmt::format("{} = {} must be a whole number, as in {}", field.key, shown(node),
                                field.example));
    if (in_range(entry, node, field, static_cast<double>(node.integer))) result = node.integer;
}

void ValueReader::read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                             bool& result) {
    if (node.kind != Kind::boolean)
        return tell(
            entry, node,
            fmt::format("{} = {} must be true or false, without quotes", field.key, shown(node)));
    result = node.boolean;
}

void ValueReader::read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                             std::string& result) {
    const bool as_written =
        !entry.origin.empty() && node.kind != Kind::array && node.kind != Kind::table;
    if (node.kind != Kind::string && !as_written)
        return tell(entry, node,
                    fmt::format("{} = {} must be a word in quotes, as in {}", field.key,
                                shown(node), written_example(field)));
    result = node.text;  // also if unknown: what depends on a misspelt word is not judged by
                         // the default
    const auto words = split(field.choices, '|');
    if (words.empty() || std::find(words.begin(), words.end(), node.text) != words.end()) return;
    const auto near = closest(node.text, words);
    tell(entry, node,
         fmt::format("{} = {} is not one of {}{}", field.key, shown(node), fmt::join(words, ", "),
                     near ? fmt::format("; did you mean \"{}\"?", *near) : ""));
}

void ValueReader::read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                             Measure& result) {
    double number = 0.0;
    if (node.kind != Kind::string) {
        const std::size_t before = faults.size();
        read_value(entry, node, field, number);
        if (faults.size() == before) result = {number, Dimension{}};
        return;
    }
    try {
        const Measure given = parse_measure(node.text);
        if (in_range(entry, node, field, given.si)) result = given;
    } catch (const UnitError& error) {
        tell(entry, node,
             fmt::format("{} = {}: {}; for example {}", field.key, shown(node), error.what(),
                         written_example(field)));
    }
}

std::vector<TomlNode> ValueReader::listed_items(std::string_view text) {
    if (!text.empty() && text.front() == '[') text.remove_prefix(1);
    if (!text.empty() && text.back() == ']') text.remove_suffix(1);
    std::vector<TomlNode> items;
    for (std::string_view part : split(text, ',')) {
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        items.push_back(parse_toml_value(std::string(part)));
    }
    return items;
}

/// The SI value of a node that should be a quantity of this dimension; a fault and nothing if
/// it is not.
std::optional<double> ValueReader::measure(const TomlEntry& entry, const TomlNode& node,
                                           const FieldText& field, Dimension dimension) {
    const bool number = node.kind == Kind::integer || node.kind == Kind::real;
    if (node.kind != Kind::string && !number) {
        tell(entry, node,
             fmt::format("{} = {} must be a number with its unit, as in {}", field.key, shown(node),
                         written_example(field)));
        return std::nullopt;
    }
    if (number) {
        const double bare = node.kind == Kind::real ? node.real : static_cast<double>(node.integer);
        tell(entry, node,
             std::isfinite(bare) ? missing_unit(field, shown(node), bare, dimension)
                                 : fmt::format("{} = {} is not a number", field.key, shown(node)));
        return std::nullopt;
    }
    try {
        const Measure m = parse_measure(node.text);
        if (m.dimension == dimension) {
            if (in_range(entry, node, field, m.si)) return m.si;
        } else if (m.dimension == Dimension{} && number_length(node.text) == node.text.size()) {
            tell(entry, node, missing_unit(field, shown(node), m.si, dimension));
        } else {
            tell(entry, node,
                 fmt::format("{} = {} is of the kind {}, and {} is wanted, as in {}", field.key,
                             shown(node), dimension_name(m.dimension), dimension_name(dimension),
                             written_example(field)));
        }
    } catch (const UnitError& error) {
        tell(entry, node,
             fmt::format("{} = {}: {}; for example {}", field.key, shown(node), error.what(),
                         written_example(field)));
    }
    return std::nullopt;
}

bool ValueReader::in_range(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                           double si) {
    if (std::isfinite(si) && field.range.contains(si)) return true;
    if (!std::isfinite(si))
        tell(entry, node, fmt::format("{} = {} must be a finite number", field.key, shown(node)));
    else
        tell(entry, node,
             fmt::format("{} = {} {}{}", field.key, shown(node),
                         range_text(field.range, unit_of(field.example)),
                         meant_percent(node, field, si)
                             ? fmt::format("; write \"{} %\"", to_text(si))
                             : ""));
    return false;
}

}  // namespace tt
