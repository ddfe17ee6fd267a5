#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "observe/provenance.hpp"

namespace tt {

/// A case file and the files that cases made of it name, as a directory keeps them: below inputs/,
/// in the same places beside the case where they lie beside it, so that the copy reads as the
/// original. Each once.
std::vector<InputFile> kept_inputs(const std::filesystem::path& case_file, const std::string& text,
                                   const std::vector<const Case*>& cases);

/// The case file that is named in a file of `folder`: there, else its copy in inputs/.
std::filesystem::path find_case(const std::filesystem::path& folder, const std::string& named);

}  // namespace tt
