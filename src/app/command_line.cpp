#include "app/command_line.hpp"
#include "base/tell.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/letter.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include "observe/failure.hpp"

namespace tt {
namespace {

/// CLI11's help in 80 columns, without the types it thinks options have.
class HelpFormatter : public CLI::Formatter {
public:
    HelpFormatter() {
        column_width(24);
        label("SUBCOMMAND", "VERB");
        label("Positionals", "Arguments");
    }
    std::string make_description(const CLI::App* app) const override {
        return wrapped(app->get_description(), 79) + "\n\n";
    }
    std::string make_option_opts(const CLI::Option*) const override { return {}; }
    std::string make_footer(const CLI::App* app) const override {
        return app->get_footer().empty() ? "" : app->get_footer() + "\n";
    }
};

void describe_program(CLI::App& app) {
    app.description(
        "Simulates red blood cells in two-dimensional flow: plasma by lattice Boltzmann, cells as "
        "elastic membranes coupled by immersed boundaries.");
    app.footer(
        "Begin with:\n"
        "  tanktread new my-channel     writes my-channel.toml, with comments\n"
        "  tanktread check my-channel.toml\n"
        "  tanktread run my-channel.toml\n"
        "  tanktread report results/my-channel\n\n"
        "Exit codes: 0 done, 1 internal error or failed selftest, 2 bad command or case,\n"
        "3 unstable (last good state kept), 4 results directory in use or of another\n"
        "case, 5 cannot read or write, 75 stopped early (run again to resume).");
    app.set_version_flag("--version", "tanktread " + version_text(), "show the version");
    app.set_help_flag("-h,--help", "show this help");
    app.formatter(std::make_shared<HelpFormatter>());
    app.require_subcommand(1);
}

/// In lines of a terminal where it is read on one; a log keeps whole lines, to search in.
/// As it is: with commands to copy, whole paths in them.
int tell_whole(std::string_view message, int code) {
    const std::string text = fmt::format("tanktread: {}", message);
    tell_user("{}\n", isatty(STDERR_FILENO) != 0 ? wrapped_lines(text, 79, 2) : text);
    return code;
}

/// With what is over-long shortened.
int tell(std::string_view message, int code) { return tell_whole(with_short_words(message), code); }

/// A first word that is no verb: told with the verb that was probably meant.
bool is_unknown_verb(const CLI::App& app, int argc, const char* const* argv) {
    if (argc < 2 || argv[1][0] == '-') return false;
    const std::string_view word = argv[1];
    const auto is_it = [&](const CLI::App* verb) { return verb->get_name() == word; };
    if (!app.get_subcommands(is_it).empty()) return false;
    std::vector<std::string> owned;
    for (const CLI::App* verb : shown_verbs(app)) owned.push_back(verb->get_name());
    const std::vector<std::string_view> names(owned.begin(), owned.end());
    const auto near = closest(word, names);
    tell(fmt::format("unknown verb '{}'; {}", readable(word),
                     near ? fmt::format("did you mean '{}'?", *near)
                          : fmt::format("verbs: {}", fmt::join(names, ", "))),
         exit_code::bad_input);
    return true;
}

/// A reader that has seen enough, as `head`, needs no message.
int output_lost(int error) {
    if (error == EPIPE) return exit_code::input_output;
    return tell("cannot write to the standard output", exit_code::input_output);
}

}  // namespace

int perform(const Action& action) {
    try {
        const int code = action();
        if (std::fflush(stdout) != 0) return output_lost(errno);
        return code;
    } catch (const CommandError& error) {
        return tell(error.what(), exit_code::bad_input);
    } catch (const CaseError& error) {
        // file:line:column first, for editors
        tell_user("{}\n", with_short_words(error.what()));
        const std::size_t count = error.faults().size();
        return tell(count == 1 ? "1 fault; nothing was run"
                               : fmt::format("{} faults; nothing was run", count),
                    exit_code::bad_input);
    } catch (const IoError& error) {
        return tell(error.what(), exit_code::input_output);
    } catch (const DirectoryInUse& error) {
        return tell(error.what(), exit_code::directory_in_use);
    } catch (const StoppedEarly& stop) {
        return tell(stop.what(), exit_code::stopped_early);
    } catch (const SimulationError& error) {
        return tell_whole(error.what(), exit_code::unstable);
    } catch (const std::filesystem::filesystem_error& error) {
        return tell(
            fmt::format("cannot use '{}': {}", error.path1().string(), error.code().message()),
            exit_code::input_output);
    } catch (const FailedBefore& error) {
        return tell_whole(error.what(), exit_code::unstable);
    } catch (const std::bad_alloc&) {
        return tell("not enough memory; take a larger dx or a smaller box", exit_code::internal);
    } catch (const std::system_error& error) {
        if (std::ferror(stdout)) return output_lost(error.code().value());
        return tell(fmt::format("internal error: {}", error.what()), exit_code::internal);
    } catch (const std::exception& error) {
        return tell(fmt::format("internal error: {}", error.what()), exit_code::internal);
    }
}

/// "help run" is "run --help", "help" is "--help".
std::vector<const char*> with_help_last(int argc, const char* const* argv) {
    std::vector<const char*> words(argv, argv + argc);
    if (argc < 2 || std::string_view(argv[1]) != "help") return words;
    words.erase(words.begin() + 1);
    words.resize(std::min<std::size_t>(words.size(), 2));
    words.push_back("--help");
    return words;
}

std::vector<const CLI::App*> shown_verbs(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

int run_command_line(int given, const char* const* words) {
    message_writer = write_plainly;
    const std::vector<const char*> arguments = with_help_last(given, words);
    const int argc = static_cast<int>(arguments.size());
    const char* const* argv = arguments.data();
    CLI::App app("", "tanktread");
    Action action;
    std::string command_line = "tanktread";
    for (int i = 1; i < argc; ++i) command_line += std::string(" ") + argv[i];
    describe_program(app);
    add_new(app, action);
    add_check(app, action);
    add_geometry(app, action);
    add_run(app, action, command_line);
    add_resume(app, action, command_line);
    add_status(app, action);
    add_report(app, action);
    add_export(app, action);
    add_sweep(app, action, command_line);
    add_calibrate(app, action, command_line);
    add_selftest(app, action);
    add_keys(app, action);
    for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        verb->group("Verbs");
    add_manual(app, action);
    add_complete(app, action);
    if (argc < 2) {
        tell_user("{}", app.help());
        return exit_code::bad_input;
    }
    if (is_unknown_verb(app, argc, argv)) return exit_code::bad_input;
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)  // --help, --version
            return perform([&] {
                const int code = app.exit(error);
                if (!std::cout.flush()) throw std::system_error(errno, std::generic_category());
                return code;
            });
        return tell(fmt::format("{}\nsee tanktread {}--help", error.what(),
                                app.get_subcommands().empty()
                                    ? std::string{}
                                    : app.get_subcommands().front()->get_name() + " "),
                    exit_code::bad_input);
    }
    return perform(action);
}

}  // namespace tt
