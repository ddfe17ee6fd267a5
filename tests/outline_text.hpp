#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "case/read_outline.hpp"
#include "membrane/shapes.hpp"

namespace tt {

/// The points as a file has them, one a line.
inline std::string text_of(const std::vector<Vec2>& points, const char* format = "{},{}\n") {
    std::string text;
    for (const Vec2 p : points) text += fmt::format(fmt::runtime(format), p.x, p.y);
    return text;
}

/// An ellipse of 6 by 4.
inline const std::vector<Vec2> ellipse_60 = ellipse(3.0, 2.0, 60);

/// With the first again at the end.
inline std::vector<Vec2> repeated(std::vector<Vec2> points) {
    points.push_back(points.front());
    return points;
}

/// All faults, one a line, or "none".
inline std::string faults_of(const std::string& text, const OutlineShape& shape = {}) {
    try {
        read_outline(text, "o.csv", shape);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "none";
}

}  // namespace tt
