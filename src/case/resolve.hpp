#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "observe/provenance.hpp"
#include "simulation/model.hpp"

namespace tt {

/// The files that a case was read from beside the case file, as a results directory keeps them.
std::vector<InputFile> inputs_of(const Case& c);

/// The case, its files named by a checksum of what is in them: two files of one content are one
/// input, wherever they lie, and one that has changed is another.
Case named_by_content(Case c);

/// resolved.toml: the case with every default, and what follows from it, in SI and lattice units,
/// as comments below. Reads back to the same Case, so that it runs again as it is; files are named
/// as `inputs_of` does.
std::string resolved_toml(const Case& c, const Choice& choice, const Model& model);

/// All of a case and of what was chosen for it, a line `table.key = value` each: by these a results
/// directory knows its case. A file stands there by the checksum of its content. What was chosen is
/// `chosen.key`: another version may choose otherwise.
std::string settings_of(const Case& c, const Choice& choice);

}  // namespace tt
