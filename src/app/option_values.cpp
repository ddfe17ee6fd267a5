#include "app/option_values.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/letter.hpp"
#include "base/words.hpp"

namespace tt {
namespace {

/// "a, b (what it is) or c".
std::string listed(const std::vector<OptionWord>& words) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (k > 0) text += k + 1 < words.size() ? ", " : " or ";
        text += words[k].word;
        if (!words[k].meaning.empty()) text += fmt::format(" ({})", words[k].meaning);
    }
    return text;
}

/// Empty if `given` is one of `words`; else what is wrong with it.
std::string fault_of(const std::string& given, const std::vector<OptionWord>& words) {
    std::vector<std::string_view> names;
    for (const OptionWord& w : words) {
        if (w.word == given) return {};
        names.push_back(w.word);
    }
    const auto near = closest(given, names);
    return fmt::format("{} is not one of {}{}", readable(given), fmt::join(names, ", "),
                       near ? fmt::format("; did you mean '{}'?", *near) : "");
}

}  // namespace

CLI::Option* add_choice(CLI::App& verb, const std::string& name, std::string& value,
                        const std::vector<OptionWord>& words, const std::string& meaning) {
    std::string bars;
    for (const OptionWord& w : words) bars += (bars.empty() ? "" : "|") + w.word;
    return verb.add_option(name, value, listed(words) + (meaning.empty() ? "" : "; ") + meaning)
        ->type_name(bars)
        ->check([words](const std::string& given) { return fault_of(given, words); });
}

std::string kind_of_value(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return {};
    const std::string kind = option.get_type_name();
    return kind.substr(0, kind.find(':'));  // after it stand the ranges that CLI11 adds
}

}  // namespace tt
