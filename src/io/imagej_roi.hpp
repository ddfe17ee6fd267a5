#pragma once

#include <string>
#include <string_view>

#include "io/point_list.hpp"

namespace tt {

/// Whether the bytes begin as a region of interest saved by ImageJ does.
bool is_imagej_roi(std::string_view bytes);

/// The points of a region saved by ImageJ (`.roi`), in pixels, y downwards. Of type polygon,
/// freehand or traced, which alone hold the coordinates of a closed outline: whole ones, relative
/// to the upper left corner, or those of parts of pixels. Layout: a header of 64 bytes, big-endian,
/// then all x, then all y (RoiDecoder of ImageJ 1.53). Throws CaseError that names the type of any
/// other region, and for bytes that are cut short.
PointList parse_imagej_roi(std::string_view bytes, const std::string& name);

}  // namespace tt
