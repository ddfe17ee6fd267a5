#pragma once

namespace tt {

/// Reads the command line, does what it asks, tells errors on stderr. Returns the exit code
/// (app/verb.hpp).
int run_command_line(int argc, const char* const* argv);

}  // namespace tt
