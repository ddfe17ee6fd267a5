#include "case/sweep_axis.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/letter.hpp"
#include "base/units.hpp"
#include "case/sweep_values.hpp"

namespace tt {
namespace {

using Kind = TomlNode::Kind;

/// A value of a TOML text as it stands after --set KEY=.
std::string setting_of(const TomlNode& node) {
    switch (node.kind) {
        case Kind::string:
            return toml_string(node.text);
        case Kind::integer:
            return fmt::format("{}", node.integer);
        case Kind::real:
            return to_text(node.real);
        case Kind::boolean:
            return node.boolean ? "true" : "false";
        case Kind::array: {
            std::string text;
            for (const TomlNode& item : node.items)
                text += (text.empty() ? "" : ", ") + setting_of(item);
            return "[" + text + "]";
        }
        default:
            return node.text;
    }
}

/// What people read of a value: without quotes and brackets.
std::string shown(const TomlNode& node) {
    if (node.kind == Kind::array) {
        std::string text;
        for (const TomlNode& item : node.items) text += (text.empty() ? "" : ", ") + shown(item);
        return text.empty() ? "none" : text;
    }
    if (node.kind != Kind::string) return setting_of(node);
    std::string_view text = node.text;
    if (text.starts_with('[') && text.ends_with(']'))
        text = trimmed(text.substr(1, text.size() - 2));
    return std::string(text);
}

SweepValue value_at(const Fault& place, std::string setting) {
    return {shown(parse_toml_value(setting)), std::move(setting), place};
}

/// Tells keys that stand twice, and those with another number of values than the first.
void judge(const SweepAxis& axis, const Fault& place, std::vector<Fault>& faults) {
    const auto tell = [&](const std::string& message) {
        faults.push_back(place);
        faults.back().message = message;
    };
    for (std::size_t k = 0; k < axis.keys.size(); ++k) {
        const SweptKey& now = axis.keys[k];
        if (now.values.empty()) return;  // told already
        for (std::size_t j = 0; j < k; ++j)
            if (axis.keys[j].key == now.key) tell(now.key + " is written twice");
        if (now.values.size() != axis.size())
            tell(fmt::format(
                "{} has {} values and {} has {}; keys that change together have as many, "
                "others are axes of their own",
                axis.keys.front().key, axis.size(), now.key, now.values.size()));
    }
}

/// The keys below a table, "flow.shear_number".
void gather(const TomlNode& table, const std::string& path, const std::string& name,
            SweepAxis& axis, std::vector<Fault>& faults) {
    for (const TomlEntry& entry : table.entries) {
        const std::string key = path + entry.key;
        if (entry.value.kind == Kind::table) {
            gather(entry.value, key + ".", name, axis, faults);
            continue;
        }
        const Fault place{name, entry.value.line, entry.value.column, {}};
        SweptKey swept{key, {}};
        if (entry.value.kind == Kind::array) {
            for (const TomlNode& item : entry.value.items)
                swept.values.push_back(
                    value_at({name, item.line, item.column, {}}, setting_of(item)));
        } else if (entry.value.kind == Kind::string) {
            swept.values = listed_values(entry.value.text, place, faults);
        } else {
            swept.values.push_back(value_at(place, setting_of(entry.value)));
        }
        if (entry.value.kind == Kind::array && swept.values.empty()) {
            faults.push_back(place);
            faults.back().message = key + " has no values";
        }
        axis.keys.push_back(std::move(swept));
    }
}

}  // namespace

std::vector<SweepValue> listed_values(std::string_view text, const Fault& place,
                                      std::vector<Fault>& faults) {
    std::vector<SweepValue> values;
    try {
        for (std::string& setting : listed_settings(text))
            values.push_back(value_at(place, std::move(setting)));
    } catch (const SweepError& error) {
        faults.push_back(place);
        faults.back().message = error.what();
    }
    return values;
}

SweepAxis axis_of_option(const std::string& text, std::vector<Fault>& faults) {
    const Fault place{"--over " + readable(text), 0, 0, {}};
    SweepAxis axis;
    for (const std::string_view part : cut(text, ';')) {
        const std::size_t equals = part.find('=');
        const std::string key(trimmed(part.substr(0, equals)));
        if (equals == part.npos || key.empty() || key.find('.') == key.npos) {
            faults.push_back(place);
            faults.back().message =
                "write --over table.key=VALUES, as in --over flow.shear_number=0.1:1:0.1";
            return {};
        }
        axis.keys.push_back({key, listed_values(part.substr(equals + 1), place, faults)});
    }
    judge(axis, place, faults);
    return axis;
}

SweepAxis axis_of_table(const TomlNode& table, const std::string& name,
                        std::vector<Fault>& faults) {
    SweepAxis axis;
    const Fault place{name, table.line, table.column, {}};
    gather(table, "", name, axis, faults);
    if (axis.keys.empty()) {
        faults.push_back(place);
        faults.back().message =
            "no key stands in [[over]]; write for example flow.shear_number = \"0.1:1:0.1\"";
    }
    judge(axis, place, faults);
    return axis;
}

std::string to_toml(const SweepAxis& axis) {
    std::string text = "[[over]]\n";
    for (const SweptKey& swept : axis.keys) {
        std::string list;
        for (const SweepValue& value : swept.values) {
            const TomlNode node = parse_toml_value(value.setting);
            list += (list.empty() ? "" : ", ") +
                    (node.kind == Kind::string ? toml_string(node.text) : value.setting);
        }
        text += fmt::format("{} = [{}]\n", swept.key, list);
    }
    return text;
}

}  // namespace tt
