#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/option_values.hpp"
#include "app/verb.hpp"
#include "base/letter.hpp"
#include "case/reference.hpp"

namespace tt {
namespace {

struct KeysOptions {
    std::string word;
    bool markdown = false;
};

int show_keys(const KeysOptions& options) {
    const std::string text = options.markdown ? reference_markdown() : reference_text(options.word);
    if (text.empty())
        throw CommandError(
            fmt::format("no key has '{}' in its name or meaning", readable(options.word)));
    fmt::print("{}", text);
    return exit_code::done;
}

}  // namespace

void add_keys(CLI::App& app, Action& action) {
    auto options = std::make_shared<KeysOptions>();
    CLI::App* verb =
        app.add_subcommand("keys", "show the keys of the case file and what they mean");
    verb->add_option("word", options->word, "only keys with this in their name or meaning")
        ->type_name(value_kind::key);
    verb->add_flag("--markdown", options->markdown, "as a page (docs/keys.md)");
    verb->callback([options, &action] { action = [options] { return show_keys(*options); }; });
}

}  // namespace tt
