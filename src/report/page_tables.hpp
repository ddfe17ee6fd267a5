#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/results.hpp"

namespace tt {

/// Sections of the report page, as HTML. One run: with meanings; several: side by side.
std::string differences_section(std::span<const Results> runs,
                                const std::vector<std::string>& labels);
std::string summary_section(std::span<const Results> runs, const std::vector<std::string>& labels);
std::string checks_section(std::span<const Results> runs, const std::vector<std::string>& labels);
std::string provenance_section(std::span<const Results> runs,
                               const std::vector<std::string>& labels);

}  // namespace tt
