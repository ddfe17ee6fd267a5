#pragma once

#include <filesystem>
#include <span>
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
/// is. What an earlier export left in `out` goes. Throws IoError: no frames, cannot write, files of
/// others in `out`.
void export_csv(const std::filesystem::path& directory, const std::filesystem::path& out);

/// Files folder/`before`NNNNNN`behind`, six digits or more.
struct NumberedFiles {
    const char *folder, *before, *behind;
};

/// Makes `out` with its README.txt, and takes away what an earlier export left. Throws IoError
/// where it holds files of others.
void begin_export(const std::filesystem::path& out, std::string_view readme,
                  std::span<const NumberedFiles> earlier);

}  // namespace tt
