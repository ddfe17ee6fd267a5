#pragma once

#include <filesystem>
#include <string>

namespace tt {

/// The page of a sweep, which needs no network: what differs between its runs, each quantity
/// against the swept keys, differences between two points, and a table of all runs. IoError if
/// sweep.json cannot be read. Links are as from a page in `out`.
std::string sweep_page(const std::filesystem::path& directory, const std::filesystem::path& out);

/// Writes it as report.html into `out`; empty: into the directory itself. Returns its path.
std::filesystem::path write_sweep_page(const std::filesystem::path& directory,
                                       const std::filesystem::path& out = {});

}  // namespace tt
