#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tt {

/// A page of the manual: roff with the macros of man(7).
struct ManualPage {
    std::string file;  ///< "tanktread-run.1"
    std::string text;
};

/// The pages of the program, of each of its verbs and of the case file: what the help and the
/// reference of keys say.
std::vector<ManualPage> manual_pages(const CLI::App& app);

}  // namespace tt
