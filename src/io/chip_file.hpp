#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tt {

/// Kinds of files that drawings come in, by the end of their names.
enum class DrawingKind { points, dxf, svg, gds, png, unknown };
DrawingKind drawing_kind(const std::filesystem::path& file);

/// A drawing and how to read it; lengths in µm.
struct ChipDrawing {
    std::filesystem::path file;  ///< its name, for its ending and for messages
    std::string bytes;
    std::optional<std::string> layer;
    std::optional<double> unit, pixel, chord;
    std::string_view fluid;  ///< inside, outside, bright, dark
};

/// The loops of a drawing.
struct ChipLoops {
    std::string csv;  ///< x,y [µm], loops parted by empty lines
    std::vector<std::pair<std::string, std::string>> found;  ///< what was read: label and text
    std::vector<std::string> remarks;                        ///< what the user should look at
};

/// Reads it with the Python package of src/io/chips, which runs as a program of its own. Throws
/// CaseError with what is wrong, IoError where Python or a library is missing. The same bytes give
/// the same loops.
ChipLoops read_chip(const ChipDrawing& drawing);

/// What the loops are made of, as the first line of the file that keeps them: a checksum of the
/// drawing, and how it was read.
std::string chip_heading(const ChipDrawing& drawing);

}  // namespace tt
