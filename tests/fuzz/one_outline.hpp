#pragma once

#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "case/read_outline.hpp"

namespace tt {

/// What any bytes at all must survive as the file of an outline, in µm or in pixels: they are
/// refused, or give a closed line of finite numbers, counter-clockwise. Tells whether any was
/// taken.
inline bool try_as_outline(std::string_view bytes) {
    OutlineShape pixels;
    pixels.pixel = Length{1e-7};
    pixels.y_down = true;
    OutlineShape smoothed = pixels;
    smoothed.smoothing = Length{1.5e-7};
    bool taken = false;
    for (const OutlineShape& shape : {OutlineShape{}, pixels, smoothed}) {
        try {
            const CellOutline outline = read_outline(bytes, "outline.csv", shape);
            const OutlineMeasures measures = measures_of(outline);
            if (!(measures.area > 0.0) || !std::isfinite(measures.perimeter)) __builtin_trap();
            taken = true;
        } catch (const CaseError&) {
        }
    }
    return taken;
}

}  // namespace tt
