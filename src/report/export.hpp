#pragma once

#include <filesystem>
#include <string_view>

namespace tt {

/// Writes the frames of a results directory for ParaView into `out`: flow.pvd with one image (.vti)
/// a frame that has fields, cells.pvd with outlines and triangles (.vtp), and README.txt, which
/// names every array. Units are µm and ms, so velocities are mm/s, because ParaView's tolerances
/// suit numbers near one; node forces stay N/m (per unit depth). What an earlier export left in
/// `out` goes. Throws IoError: no frames, cannot write.
void export_vtk(const std::filesystem::path& directory, const std::filesystem::path& out);

/// Writes the frames as plain tables in SI: frames.csv (number, time, step), nodes_NNNNNN.csv and
/// fields_NNNNNN.csv for each frame (if it has fields), and README.txt, which says what each column
/// is. What an earlier export left in `out` goes. Throws IoError: no frames, cannot write.
void export_csv(const std::filesystem::path& directory, const std::filesystem::path& out);

/// Removes `before`NNNNNN`behind`, six digits or more, from a folder.
void remove_numbered(const std::filesystem::path& folder, std::string_view before,
                     std::string_view behind);

}  // namespace tt
