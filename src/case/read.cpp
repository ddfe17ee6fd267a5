#include "case/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/words.hpp"
#include "case/field_types.hpp"
#include "case/schema.hpp"
#include "case/validate.hpp"
#include "io/file.hpp"
#include "io/toml.hpp"

namespace tt {
namespace {

using Kind = TomlNode::Kind;

/// A field without its type: what faults need to say.
struct FieldText {
    std::string_view key;
    Range range;
    std::string_view choices;
    std::string_view example;
};

std::string shown(const TomlNode& node) {
    switch (node.kind) {
        case Kind::string:
            return toml_string(node.text);
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

/// The paths of all tables that have a field `key`.
template <Table S>
void find_key(std::string_view key, const std::string& path, std::vector<std::string>& found) {
    for_each_field<S>([&](const auto& field) {
        using T = std::remove_cvref_t<decltype(std::declval<S>().*field.member)>;
        if (field.key == key && !path.empty()) found.push_back(path);
        if constexpr (Table<T>)
            find_key<T>(
                key, path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key),
                found);
    });
}

/// Walks the tree along the field lists. Goes on after a fault; what could not be read keeps its
/// default.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    template <Table S>
    void read_table(const TomlNode& table, const TomlEntry* header, const std::string& path,
                    S& result) {
        for (const TomlEntry& entry : table.entries) {
            bool known = false;
            for_each_field<S>([&](const auto& field) {
                if (field.key != entry.key) return;
                known = true;
                read_field(entry, join(path, field.key), field, result.*field.member);
            });
            if (!known) tell_unknown_key<S>(entry, path);
        }
        for_each_field<S>([&](const auto& field) {
            if (table.find(field.key) == nullptr)
                read_absent(header, join(path, field.key), field, result.*field.member);
        });
    }

    std::vector<Fault> faults;
    Places places;

private:
    static std::string join(const std::string& path, std::string_view key) {
        return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
    }

    template <class F>
    static FieldText text_of(const F& field) {
        return {field.key, field.range, field.choices, field.example};
    }

    Fault place(const TomlEntry& entry, int line, int column) const {
        if (!entry.origin.empty()) return {entry.origin, 0, 0, {}};
        return {file_, line, column, {}};
    }
    void tell(const TomlEntry& entry, const TomlNode& value, std::string message) {
        faults.push_back(place(entry, value.line, value.column));
        faults.back().message = std::move(message);
    }
    void tell_key(const TomlEntry& entry, std::string message) {
        faults.push_back(place(entry, entry.line, entry.column));
        faults.back().message = std::move(message);
    }

    template <class F, class T>
    void read_field(const TomlEntry& entry, const std::string& path, const F& field, T& result) {
        if constexpr (Table<T>) {
            if (entry.value.kind == Kind::table)
                return read_table(entry.value, &entry, path, result);
            const bool twice = entry.value.kind == Kind::array;
            tell_key(entry, fmt::format("{} is a table; write [{}] on a line of its own{}",
                                        field.key, path, twice ? ", once" : ""));
        } else {
            if constexpr (is_optional<T>) {
                if (entry.value.kind == Kind::string && entry.value.text == "auto") return;
            }
            places[path] = place(entry, entry.line, entry.column);
            read_value(entry, entry.value, text_of(field), result);
        }
    }

    template <class F, class T>
    void read_absent(const TomlEntry* header, const std::string& path, const F& field, T& result) {
        if constexpr (Table<T>) {
            read_table(TomlNode{}, header, path, result);
        } else if constexpr (is_quantity<T>) {
            if (field.range.contains(result.si)) return;
            const std::string table = path.substr(0, path.rfind('.'));
            Fault fault = header != nullptr ? place(*header, header->line, header->column)
                                            : Fault{file_, 0, 0, {}};
            fault.message = fmt::format("{} is missing from [{}]; write {} = {}", field.key, table,
                                        field.key, toml_string(field.example));
            faults.push_back(std::move(fault));
        }
    }

    template <Table S>
    void tell_unknown_key(const TomlEntry& entry, const std::string& path) {
        std::vector<std::string_view> keys;
        for_each_field<S>([&](const auto& field) { keys.push_back(field.key); });
        std::vector<std::string> elsewhere;
        find_key<Case>(entry.key, "", elsewhere);
        std::string message =
            path.empty() ? fmt::format("unknown {} '{}'",
                                       entry.value.kind == Kind::table ? "table" : "key", entry.key)
                         : fmt::format("unknown key '{}' in [{}]", entry.key, path);
        if (const auto near = closest(entry.key, keys); near && elsewhere.empty())
            message += fmt::format("; did you mean '{}'?", *near);
        else if (!elsewhere.empty())
            message += fmt::format("; it belongs to [{}]", fmt::join(elsewhere, "] or ["));
        else
            message += fmt::format("; known here: {}", fmt::join(keys, ", "));
        tell_key(entry, std::move(message));
    }

    template <class T>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::optional<T>& result) {
        T value{};
        read_value(entry, node, field, value);
        result = value;  // also if faulty: the key is given
    }

    template <Dimension D>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    Quantity<D>& result) {
        if (const auto si = measure(entry, node, field, D)) result.si = *si;
    }

    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
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

    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::int64_t& result) {
        if (node.kind != Kind::integer)
            return tell(entry, node,
                        fmt::format("{} = {} must be a whole number, as in {}", field.key,
                                    shown(node), field.example));
        if (in_range(entry, node, field, static_cast<double>(node.integer))) result = node.integer;
    }

    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    bool& result) {
        if (node.kind != Kind::boolean)
            return tell(entry, node,
                        fmt::format("{} = {} must be true or false, without quotes", field.key,
                                    shown(node)));
        result = node.boolean;
    }

    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
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
        if (words.empty() || std::find(words.begin(), words.end(), node.text) != words.end())
            return;
        const auto near = closest(node.text, words);
        tell(entry, node,
             fmt::format("{} = {} is not one of {}{}", field.key, toml_string(node.text),
                         fmt::join(words, ", "),
                         near ? fmt::format("; did you mean \"{}\"?", *near) : ""));
    }

    template <class T>
    void read_value(const TomlEntry& entry, const TomlNode& node, const FieldText& field,
                    std::vector<T>& result) {
        const bool listed =
            !entry.origin.empty() && node.kind == Kind::string;  // --set apply_to=shear,area
        if (node.kind != Kind::array && !listed)
            return tell(entry, node,
                        fmt::format("{} = {} must be a list, as in {}", field.key, shown(node),
                                    field.example));
        result.clear();
        for (const TomlNode& item : listed ? listed_items(node.text) : node.items) {
            result.emplace_back();
            read_value(entry, item, field, result.back());
        }
    }

    static std::vector<TomlNode> listed_items(std::string_view text) {
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
    std::optional<double> measure(const TomlEntry& entry, const TomlNode& node,
                                  const FieldText& field, Dimension dimension) {
        const bool number = node.kind == Kind::integer || node.kind == Kind::real;
        if (node.kind != Kind::string && !number) {
            tell(entry, node,
                 fmt::format("{} = {} must be a number with its unit, as in {}", field.key,
                             shown(node), written_example(field)));
            return std::nullopt;
        }
        if (number) {
            const double bare =
                node.kind == Kind::real ? node.real : static_cast<double>(node.integer);
            tell(entry, node,
                 std::isfinite(bare)
                     ? missing_unit(field, node, bare, dimension)
                     : fmt::format("{} = {} is not a number", field.key, shown(node)));
            return std::nullopt;
        }
        try {
            const Measure m = parse_measure(node.text);
            if (m.dimension == dimension) {
                if (in_range(entry, node, field, m.si)) return m.si;
            } else if (m.dimension == Dimension{} && number_length(node.text) == node.text.size()) {
                tell(entry, node, missing_unit(field, node, m.si, dimension));
            } else {
                tell(entry, node,
                     fmt::format("{} = {} is of the kind {}, and {} is wanted, as in {}", field.key,
                                 shown(node), dimension_name(m.dimension),
                                 dimension_name(dimension), written_example(field)));
            }
        } catch (const UnitError& error) {
            tell(entry, node,
                 fmt::format("{} = {}: {}; for example {}", field.key, shown(node), error.what(),
                             written_example(field)));
        }
        return std::nullopt;
    }

    static std::string missing_unit(const FieldText& field, const TomlNode& node, double bare,
                                    Dimension dimension) {
        return fmt::format("{} = {} has no unit; write {} = {}", field.key, shown(node), field.key,
                           toml_string(with_unit(bare, dimension, first_example(field.example))));
    }
    static std::string_view first_example(std::string_view example) {
        const std::size_t quote = example.find('"');
        return quote == std::string_view::npos ? example
                                               : split(example.substr(quote + 1), '"').front();
    }

    bool in_range(const TomlEntry& entry, const TomlNode& node, const FieldText& field, double si) {
        if (std::isfinite(si) && field.range.contains(si)) return true;
        if (!std::isfinite(si))
            tell(entry, node,
                 fmt::format("{} = {} must be a finite number", field.key, shown(node)));
        else
            tell(entry, node,
                 fmt::format("{} = {} {}{}", field.key, shown(node),
                             range_text(field.range, unit_of(field.example)),
                             meant_percent(node, field, si)
                                 ? fmt::format("; write \"{} %\"", to_text(si))
                                 : ""));
        return false;
    }

    static bool meant_percent(const TomlNode& node, const FieldText& field, double number) {
        return node.kind != Kind::string && unit_of(field.example) == "%" &&
               field.range.contains(number / 100.0);
    }

    std::string file_;
};

/// Takes the key that excludes `path` out of the file's tree.
void remove_excluded(TomlNode& root, std::string_view path) {
    for (const Exclusive& pair : exclusive_keys) {
        const std::string_view partner = path == pair.one     ? pair.other
                                         : path == pair.other ? pair.one
                                                              : "";
        if (partner.empty()) continue;
        TomlEntry* table = root.find(partner.substr(0, partner.find('.')));
        const std::string_view key = partner.substr(partner.find('.') + 1);
        auto& entries = table->value.entries;
        entries.erase(
            std::remove_if(entries.begin(), entries.end(),
                           [&](const TomlEntry& e) { return e.key == key && e.origin.empty(); }),
            entries.end());
    }
}

/// Puts "table.key=value" into the tree as if the file had it.
void apply_override(TomlNode& root, const std::string& text, std::vector<Fault>& faults) {
    const std::string origin = "--set " + text;
    const std::size_t equals = text.find('=');
    const std::string path = text.substr(0, equals);
    const auto keys = split(path, '.');
    if (equals == std::string::npos || keys.empty() || keys.size() > 4 ||
        std::any_of(keys.begin(), keys.end(), [](std::string_view k) { return k.empty(); })) {
        faults.push_back(
            {origin, 0, 0,
             "write --set table.key=value, as in --set flow.pseudo_shear_rate=\"150 /s\""});
        return;
    }
    TomlNode* table = &root;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        TomlEntry* entry = table->find(keys[i]);
        if (entry == nullptr) {
            table->entries.push_back({std::string(keys[i]), 0, 0, {}, origin});
            entry = &table->entries.back();
        }
        if (i + 1 < keys.size() && entry->value.kind != Kind::table) {
            entry->origin = origin;
            entry->value = TomlNode{};  // the reader tells that it is no table
        }
        if (i + 1 == keys.size()) {
            entry->origin = origin;
            entry->value = parse_toml_value(text.substr(equals + 1));
        }
        table = &entry->value;
    }
    remove_excluded(root, path);
}

/// In the order of the file; options of the command line last.
void sort_faults(std::vector<Fault>& faults) {
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
        return std::tuple(a.line == 0, a.line, a.column) <
               std::tuple(b.line == 0, b.line, b.column);
    });
}

std::string default_name(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    const std::string folder = file.parent_path().filename().string();
    return stem == "case" && !folder.empty() && folder != "." ? folder : stem;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides, const std::filesystem::path& directory) {
    TomlText toml = parse_toml(text, name);
    std::vector<Fault> faults = toml.faults;
    for (const std::string& item : overrides) apply_override(toml.root, item, faults);
    Case result;
    const bool whole = toml.faults.empty();
    if (whole || !toml.root.entries.empty()) {
        Reader reader(name);
        reader.read_table(toml.root, nullptr, "", result);
        if (result.name.empty()) result.name = default_name(name);
        if (result.cells.file)
            result.cells.file = (directory / *result.cells.file).lexically_normal().string();
        const bool read = reader.faults.empty();
        // Where a line could not be read as TOML, a key may only seem to be missing.
        if (!whole)
            reader.faults.erase(std::remove_if(reader.faults.begin(), reader.faults.end(),
                                               [](const Fault& f) {
                                                   return f.message.find(" is missing from ") !=
                                                          std::string::npos;
                                               }),
                                reader.faults.end());
        const auto append = [&](std::vector<Fault> more) {
            faults.insert(faults.end(), std::make_move_iterator(more.begin()),
                          std::make_move_iterator(more.end()));
        };
        append(std::move(reader.faults));
        if (whole) append(find_conflicts(result, reader.places, name));
        if (whole && read) append(find_impossibilities(result, reader.places, name));
    }
    sort_faults(faults);
    if (!faults.empty()) throw CaseError(std::move(faults));
    return result;
}

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw IoError(fmt::format("{} is a directory; name the case file in it", path.string()));
    return parse_case(read_file(path), path.string(), overrides,
                      std::filesystem::absolute(path).parent_path());
}

}  // namespace tt
