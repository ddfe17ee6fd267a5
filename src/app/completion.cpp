#include "app/completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/option_values.hpp"
#include "app/verb.hpp"
#include "base/words.hpp"
#include "case/reference.hpp"

namespace tt {
namespace {

Completion of_words(std::vector<Candidate> words, std::string_view begun) {
    std::erase_if(words, [&](const Candidate& c) { return !c.word.starts_with(begun); });
    return {Completion::Kind::words, std::move(words)};
}

Completion of_verbs(const CLI::App& app, std::string_view begun) {
    std::vector<Candidate> words;
    for (const CLI::App* verb : shown_verbs(app))
        words.push_back({verb->get_name(), verb->get_description()});
    words.push_back({"help", "show the help of a verb"});
    return of_words(words, begun);
}

/// "flow.drive=pr", "membrane.hardening.apply_to=shear,be".
Completion of_settings(std::string_view begun) {
    const std::size_t equals = begun.find('=');
    std::vector<Candidate> words;
    for (const KeyTable& table : reference_tables())
        for (const KeyLine& line : table.keys) {
            if (equals == begun.npos) {
                words.push_back({line.full_name + "=", line.meaning});
            } else if (begun.substr(0, equals) == line.full_name) {
                const std::size_t comma = begun.rfind(',');
                const std::size_t last = comma == begun.npos ? equals : comma;
                for (const std::string& word : line.words)
                    words.push_back({std::string(begun.substr(0, last + 1)) + word, ""});
            }
        }
    return of_words(words, begun);
}

Completion of_keys(std::string_view begun) {
    std::vector<Candidate> words;
    for (const KeyTable& table : reference_tables()) {
        if (!table.name.empty()) words.push_back({table.name, table.meaning});
        for (const KeyLine& line : table.keys) words.push_back({line.full_name, line.meaning});
    }
    return of_words(words, begun);
}

/// Values of an option or argument; `before` is what stands in front of them in the same word.
Completion of_values(const CLI::Option& option, std::string_view begun, const std::string& before) {
    const std::string kind = kind_of_value(option);
    if (kind == value_kind::toml_file) return {Completion::Kind::files, {}};
    if (kind == value_kind::any_file) return {Completion::Kind::any_files, {}};
    if (kind == value_kind::directory) return {Completion::Kind::directories, {}};
    Completion found;
    if (kind == value_kind::setting || kind == value_kind::axis)
        found = of_settings(begun);
    else if (kind == value_kind::key)
        found = of_keys(begun);
    else if (kind.find('|') != std::string::npos) {
        std::vector<Candidate> words;
        for (const std::string_view word : split(kind, '|'))
            words.push_back({std::string(word), ""});
        found = of_words(words, begun);
    }
    for (Candidate& c : found.words) c.word = before + c.word;
    return found;
}

Completion of_options(const CLI::App& app, std::string_view begun) {
    std::vector<Candidate> words;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames())
            words.push_back({"--" + name, option->get_description()});
        for (const std::string& name : option->get_snames())
            words.push_back({"-" + name, option->get_description()});
    }
    return of_words(words, begun);
}

const CLI::Option* option_named(const CLI::App& app, const std::string& name) {
    return name.starts_with("-") ? app.get_option_no_throw(name) : nullptr;
}

/// The argument that comes after `count` others; the last may take several.
const CLI::Option* argument_after(const CLI::App& verb, std::size_t count) {
    const CLI::Option* last = nullptr;
    for (const CLI::Option* option : verb.get_options()) {
        if (!option->get_positional()) continue;
        last = option;
        if (count-- == 0) return option;
    }
    return last != nullptr && last->get_items_expected_max() > 1 ? last : nullptr;
}

Completion of_verb(const CLI::App& verb, const std::vector<std::string>& words) {
    const std::string& begun = words.back();
    const CLI::Option* waiting = nullptr;  // an option whose value comes next
    std::size_t arguments = 0;
    for (std::size_t k = 0; k + 1 < words.size(); ++k) {
        if (waiting != nullptr) {
            waiting = nullptr;
        } else if (!words[k].starts_with("-")) {
            ++arguments;
        } else if (const CLI::Option* option = option_named(verb, words[k])) {
            waiting = kind_of_value(*option).empty() ? nullptr : option;
        }
    }
    if (waiting != nullptr) return of_values(*waiting, begun, "");
    const std::size_t equals = begun.find('=');
    if (begun.starts_with("--") && equals != begun.npos) {
        const CLI::Option* option = option_named(verb, begun.substr(0, equals));
        if (option == nullptr) return {};
        return of_values(*option, std::string_view(begun).substr(equals + 1),
                         begun.substr(0, equals + 1));
    }
    if (begun.starts_with("-")) return of_options(verb, begun);
    const CLI::Option* argument = argument_after(verb, arguments);
    return argument == nullptr ? Completion{} : of_values(*argument, begun, "");
}

/// For the scripts in tools/completion: the kind, then a line a word.
int print_completion(const Completion& completion) {
    constexpr const char* kinds[] = {"words", "files", "any_files", "directories"};
    fmt::print("{}\n", kinds[static_cast<int>(completion.kind)]);
    for (const Candidate& c : completion.words) fmt::print("{}\t{}\n", c.word, c.meaning);
    return exit_code::done;
}

}  // namespace

Completion complete(const CLI::App& app, const std::vector<std::string>& words) {
    const std::string& first = words.front();
    if (words.size() == 1)
        return first.empty() || first[0] != '-' ? of_verbs(app, first) : of_options(app, first);
    if (first == "help") return words.size() == 2 ? of_verbs(app, words[1]) : Completion{};
    for (const CLI::App* verb : shown_verbs(app))
        if (verb->get_name() == first) return of_verb(*verb, {words.begin() + 1, words.end()});
    return {};
}

void add_complete(CLI::App& app, Action& action) {
    auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* verb = app.add_subcommand("complete", "tell what may stand where the cursor is");
    verb->group("");
    verb->add_option("words", *words, "after --: the command line up to the cursor")->required();
    verb->callback([&app, words, &action] {
        action = [&app, words] { return print_completion(complete(app, *words)); };
    });
}

}  // namespace tt
