#pragma once

#include <string>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "observe/run_case.hpp"
#include "simulation/model.hpp"

namespace CLI {
class App;
}

namespace tt {

/// Everything about the run of a case but where it goes and how the user wants to watch it.
RunRequest request_for(const Case& c, const Choice& choice, const Model& model);

/// Adds --progress; with `json` every message from there on is JSON.
void add_progress_option(CLI::App& verb, std::string& word);

/// What a word of --progress stands for.
ProgressMode progress_mode(const std::string& word);

}  // namespace tt
