#pragma once

#include <filesystem>
#include <span>

namespace tt {

/// Writes figures/ and report.html for one results directory, or for several a comparison of them,
/// and returns the path of the page. `out` empty: into the directory itself; for several, into
/// ./comparison. A run that is not finished is reported as far as it came. Throws IoError: no
/// results, gnuplot missing (says what to install), cannot write.
std::filesystem::path write_report(std::span<const std::filesystem::path> directories,
                                   const std::filesystem::path& out = {});

}  // namespace tt
