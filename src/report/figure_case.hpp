#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/loops.hpp"

namespace tt {

/// A case as it lies before its run, in the coordinates of the drawing [m].
struct CasePicture {
    /// A port, and which way plasma goes through it; `along` is 0 where that is not known.
    struct Port {
        Opening place;
        Vec2 along;
        std::string words;  ///< its name and what it holds
    };
    std::string title;
    Vec2 low, high;           ///< corners of the box
    std::vector<Loop> solid;  ///< what an odd number of them goes round
    bool side_walls = false;  ///< at the lower and upper edge of the box
    std::vector<Port> ports;
    std::vector<Loop> cells;
};

/// Draws it to a .png or .svg file. Throws IoError. Precondition: can_draw().
void draw_case(const CasePicture& picture, const std::filesystem::path& file);

/// Whether the name of a file is that of a picture which can be drawn.
bool is_picture_name(const std::filesystem::path& file);

}  // namespace tt
