#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/figures.hpp"
#include "report/page_data.hpp"

namespace tt {

/// The whole report as one page that needs no network: text, tables, figures, charts and the
/// player. `figures_folder` holds what was drawn; the page links to its data by the relative path
/// figures/.
std::string report_page(std::span<const Results> runs, const std::vector<Figure>& figures,
                        const std::filesystem::path& figures_folder, const PageLimits& limits);

}  // namespace tt
