#pragma once

#include <filesystem>
#include <vector>

#include "case/case.hpp"
#include "case/validate.hpp"
#include "io/chip_file.hpp"

namespace tt {

/// The loops that `geometry.file` names, into the case. Files of drawing programs are converted,
/// unless their loops are kept beside them. Returns what is wrong.
std::vector<Fault> read_drawn(Case& c, const Places& places);

/// Whether the file is one of a drawing program, of which loops were made.
bool is_converted(const DrawnShape& drawn);

/// Where the loops that were made of a drawing are kept, beside it.
std::filesystem::path kept_loops(const std::filesystem::path& drawing);

/// The shape as if its loops had been drawn by points; what made them is no key of it.
DrawnShape as_points(DrawnShape drawn);

/// A path as the user would write it: from the current folder where it lies below it.
std::string shown(const std::filesystem::path& path);

}  // namespace tt
