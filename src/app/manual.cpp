#include "app/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/option_values.hpp"
#include "app/verb.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "case/reference.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

/// `text` as roff shows it letter by letter. A line that begins with a dot would be a command.
std::string roff(std::string_view text) {
    std::string result;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) result += "\\&";
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '^' || c == '~' || c == '`' || c == '\'')
            result += fmt::format("\\({}", c == '^'   ? "ha"
                                           : c == '~' ? "ti"
                                           : c == '`' ? "ga"
                                                      : "aq");
        else
            result += c;
        begins = c == '\n';
    }
    return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// Paragraphs as the help has them: indented lines stay as they are, others are filled.
std::string paragraphs(std::string_view text) {
    std::string result = ".PP\n";
    bool example = false, empty = true;
    for (const std::string_view line : split(text, '\n')) {
        if (line.empty()) {
            if (example) result += ".EE\n";
            if (!empty) result += ".PP\n";
            example = false;
            empty = true;
            continue;
        }
        const bool indented = line.substr(0, 2) == "  ";
        if (indented != example) result += indented ? ".EX\n" : ".EE\n";
        example = indented;
        empty = false;
        result += roff(line) + "\n";
    }
    if (empty) result.erase(result.rfind(".PP\n"));
    return result + (example ? ".EE\n" : "");
}

/// The text with its first letter small, as in a list of names.
std::string uncapitalised(std::string text) {
    if (text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] + 32);
    return text;
}

std::string heading(const std::string& name, int section, const std::string& description) {
    return fmt::format(".TH {} {} \"\" \"tanktread {}\" \"\"\n.SH NAME\n{} \\- {}\n", roff(name),
                       section, version, roff(name), roff(description));
}

std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
    std::vector<const CLI::Option*> options;
    for (const CLI::Option* option : app.get_options())
        if (option->get_positional() == positional) options.push_back(option);
    return options;
}

/// "-o, --output DIR"; of an argument "DIR".
std::string term(const CLI::Option& option) {
    std::string text;
    for (const std::string& name : option.get_snames()) text += bold("-" + name) + ", ";
    for (const std::string& name : option.get_lnames()) text += bold("--" + name) + ", ";
    if (!text.empty()) text.replace(text.size() - 2, 2, " ");
    const std::string kind = kind_of_value(option);
    const bool words = kind.find('|') != std::string::npos;
    return text + (kind.empty() ? "" : words ? bold(kind) : italic(kind));
}

std::string synopsis(const std::string& command, const CLI::App& app) {
    std::string text = fmt::format(".SH SYNOPSIS\n{} [{}]", bold(command), italic("options"));
    for (const CLI::Option* argument : options_of(app, true)) {
        const std::string more = argument->get_items_expected_max() > 1 ? "..." : "";
        const std::string word = italic(kind_of_value(*argument)) + more;
        text += argument->get_required() ? " " + word : " [" + word + "]";
    }
    return text + "\n";
}

std::string terms(const std::string& title, const std::vector<const CLI::Option*>& options) {
    std::string text;
    for (const CLI::Option* option : options)
        text += fmt::format(".TP\n{}\n{}\n", term(*option), roff(option->get_description()));
    return text.empty() ? text : ".SH " + title + "\n" + text;
}

ManualPage page_of_verb(const CLI::App& app, const CLI::App& verb) {
    const std::string name = "tanktread-" + verb.get_name();
    std::string text = heading(name, 1, verb.get_description());
    text += synopsis("tanktread " + verb.get_name(), verb);
    // CLI11 gives a verb without a footer that of the program.
    if (verb.get_footer() != app.get_footer())
        text += ".SH DESCRIPTION\n" + paragraphs(verb.get_footer());
    text += terms("ARGUMENTS", options_of(verb, true)) + terms("OPTIONS", options_of(verb, false));
    text += ".SH SEE ALSO\n" + bold("tanktread") + "(1) has the exit codes, " +
            bold("tanktread-case") + "(5) the keys of the case file.\n";
    return {name + ".1", text};
}

ManualPage page_of_program(const CLI::App& app) {
    const std::string description = app.get_description();
    std::string text =
        heading("tanktread", 1, uncapitalised(description.substr(0, description.find(':'))));
    text += fmt::format(".SH SYNOPSIS\n{} {} [{}]\n", bold("tanktread"), italic("VERB"),
                        italic("options"));
    text += ".SH DESCRIPTION\n" + roff(description) + "\n" + paragraphs(app.get_footer());
    text += ".SH VERBS\n";
    for (const CLI::App* verb : shown_verbs(app))
        text += fmt::format(".TP\n{}(1)\n{}\n", bold("tanktread-" + verb->get_name()),
                            roff(verb->get_description()));
    text += terms("OPTIONS", options_of(app, false));
    return {"tanktread.1", text + ".SH SEE ALSO\n" + bold("tanktread-case") + "(5)\n"};
}

ManualPage page_of_case() {
    std::string text = heading("tanktread-case", 5, "the case file of tanktread and its keys");
    std::string values(how_to_write_values);
    std::erase(values, '`');
    text += ".SH DESCRIPTION\nA case file is TOML. It holds all that a run needs.\n" +
            paragraphs(values);
    for (const KeyTable& table : reference_tables()) {
        text += ".SH " + (table.name.empty() ? "At the top" : roff(table.header)) + "\n" +
                roff(table.meaning) + "\n";
        for (const KeyLine& line : table.keys)
            text += fmt::format(".TP\n{}\n{}\n{}", bold(line.example), roff(line.meaning),
                                line.bounds.empty() ? "" : ".br\n" + roff(line.bounds) + "\n");
    }
    text += ".SH SEE ALSO\n" + bold("tanktread-keys") + "(1), " + bold("tanktread-check") + "(1)\n";
    return {"tanktread-case.5", text};
}

int write_manual(const CLI::App& app, const std::filesystem::path& directory) {
    make_directory(directory);
    for (const ManualPage& page : manual_pages(app))
        replace_file(directory / page.file, page.text, Durability::process);
    return exit_code::done;
}

}  // namespace

std::vector<ManualPage> manual_pages(const CLI::App& app) {
    std::vector<ManualPage> pages{page_of_program(app), page_of_case()};
    for (const CLI::App* verb : shown_verbs(app)) pages.push_back(page_of_verb(app, *verb));
    return pages;
}

void add_manual(CLI::App& app, Action& action) {
    auto directory = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand("manual", "write the pages of the manual, roff");
    verb->group("");
    verb->add_option("directory", *directory, "where to")
        ->required()
        ->type_name(value_kind::directory);
    verb->callback([&app, directory, &action] {
        action = [&app, directory] { return write_manual(app, *directory); };
    });
}

}  // namespace tt
