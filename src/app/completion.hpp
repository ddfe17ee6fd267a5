#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tt {

/// A word that may stand where the cursor is.
struct Candidate {
    std::string word;
    std::string meaning;
};

/// What may stand where the cursor is.
struct Completion {
    enum class Kind { words, files, any_files, directories } kind = Kind::words;
    std::vector<Candidate> words;  ///< of kind words
};

/// What may stand in place of the last of `words`: what stands after "tanktread" up to the cursor,
/// the last word perhaps empty.
Completion complete(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace tt
