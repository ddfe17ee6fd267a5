#pragma once

#include <filesystem>

namespace tt {

/// Writes the frames of a results directory for ParaView into `out`: flow.pvd with one image (.vti)
/// a frame, and cells.pvd with one set of polygons (.vtp) a frame. Units are µm and ms, so
/// velocities are mm/s, because ParaView's tolerances suit numbers near one; node forces stay N/m
/// (per unit depth). Throws IoError: no frames, cannot write.
void export_vtk(const std::filesystem::path& directory, const std::filesystem::path& out);

/// Writes the frames as plain tables in SI: frames.csv (number, time, step), nodes_NNNNNN.csv and
/// fields_NNNNNN.csv for each frame, and README.txt, which says what each column is. Throws
/// IoError: no frames, cannot write.
void export_csv(const std::filesystem::path& directory, const std::filesystem::path& out);

}  // namespace tt
