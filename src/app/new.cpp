#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/option_values.hpp"
#include "app/templates.hpp"
#include "base/tell.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "case/run_name.hpp"
#include "io/file.hpp"
#include "io/toml.hpp"

namespace tt {
namespace {

struct NewOptions {
    std::string name;
    std::string from = "channel";
};

const Template& find_template(const std::string& name) {
    return *std::find_if(templates.begin(), templates.end(),
                         [&](const Template& t) { return t.name == name; });
}

/// The template with `name = …` for the new run.
std::string renamed(std::string text, const std::string& name) {
    const std::size_t begin = text.find("\nname ") + 1;
    const std::size_t value = text.find('"', begin);
    const std::size_t end = text.find('\n', value);
    return text.replace(value, end - value, toml_string(name));
}

int write_case(const NewOptions& options) {
    if (options.name.empty()) throw CommandError("new needs a name; write for example new channel");
    const std::filesystem::path given = options.name;
    const bool named = given.extension() == ".toml";
    const std::filesystem::path path =
        named ? given : std::filesystem::path(options.name + ".toml");
    const Template& chosen = find_template(options.from);
    const std::filesystem::path outline = path.parent_path() / chosen.outline_name;
    std::vector<std::filesystem::path> files{path};
    if (!chosen.outline.empty()) files.push_back(outline);
    for (const auto& file : files)
        if (std::filesystem::exists(file))
            throw IoError(fmt::format("{} is there already; choose another name or remove it",
                                      file.string()));
    if (path.has_parent_path()) make_directory(path.parent_path());
    replace_file(path, renamed(std::string(chosen.text), name_from(path.stem().string())),
                 Durability::process);
    if (!chosen.outline.empty()) replace_file(outline, chosen.outline, Durability::process);
    for (const auto& file : files) fmt::print("wrote {}\n", file.string());
    std::fflush(stdout);  // before what goes to stderr
    tell_user("next:  tanktread check {0}\n       tanktread run {0}\n", path.string());
    return exit_code::done;
}

}  // namespace

void add_new(CLI::App& app, Action& action) {
    auto options = std::make_shared<NewOptions>();
    CLI::App* verb = app.add_subcommand("new", "write a commented case file to start from");
    verb->add_option("name", options->name, "of the run; NAME.toml is written")
        ->required()
        ->type_name(value_kind::name);
    std::vector<OptionWord> words;
    for (const Template& t : templates) words.push_back({std::string(t.name), ""});
    add_choice(*verb, "--from", options->from, words)->description("which of these:");
    verb->footer(
        "  channel     twelve cells in a channel 20 um wide, the paper's Case III\n"
        "  shear       one cell tank-treading between walls 40 um apart\n"
        "  relax       a stretched cell that returns to its circle\n"
        "  poiseuille  plasma alone in a channel\n"
        "  couette     two fluids between sliding walls\n"
        "  stenosis    cells through a channel that narrows from 20 to 8 um\n"
        "  fork        cells in a channel that forks, between ports\n"
        "  posts       a cell in an array of posts that sorts by size\n"
        "  chip        cells in a chip drawn in a CAD program, with a bypass\n\n"
        "Without --from it is a channel. A file that is there already is never\n"
        "overwritten.");
    verb->callback([options, &action] { action = [options] { return write_case(*options); }; });
}

}  // namespace tt
