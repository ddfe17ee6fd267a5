#pragma once

#include <filesystem>

#include "simulation/model.hpp"

namespace tt {

/// places.json: where ports and sections are and how they belong together, in coordinates of the
/// drawing [m], for whoever reads a results directory. Nothing where there are none.
void write_places(const std::filesystem::path& results, const Model& model);

}  // namespace tt
