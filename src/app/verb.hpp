#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tt {

/// Exit codes, the same for every verb.
namespace exit_code {
inline constexpr int done = 0;
inline constexpr int internal = 1;
inline constexpr int bad_input = 2;  ///< command or case
inline constexpr int unstable = 3;
inline constexpr int directory_in_use = 4;
inline constexpr int input_output = 5;
inline constexpr int stopped_early = 75;  ///< EX_TEMPFAIL: run again to resume
}  // namespace exit_code

/// The command line cannot be done as it stands (exit 2). The message says what to write.
class CommandError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What the command line asks for, to be done once all of it has been read. Returns the exit code.
using Action = std::function<int()>;

/// Does it. What it throws is told on stderr; each kind of error has its exit code.
int perform(const Action& action);

// Each adds one verb with its options and help; when it is named, `action` becomes what it does.
void add_new(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_geometry(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action, const std::string& command_line);
void add_resume(CLI::App& app, Action& action, const std::string& command_line);
void add_status(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action, const std::string& command_line);
void add_calibrate(CLI::App& app, Action& action, const std::string& command_line);
void add_selftest(CLI::App& app, Action& action);
void add_keys(CLI::App& app, Action& action);

// Two that are no help to people: the build and the shells call them.
void add_manual(CLI::App& app, Action& action);
void add_complete(CLI::App& app, Action& action);

/// The verbs that help, manual and completion show.
std::vector<const CLI::App*> shown_verbs(const CLI::App& app);

}  // namespace tt
