#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/choice.hpp"
#include "base/quantity.hpp"
#include "case/cell_outline.hpp"

namespace tt {

// [cells]: what they are, how many, and where they start.

/// Of a cell [m].
inline constexpr double smallest_radius = 1e-7;

struct CircleShape {
    static constexpr std::string_view name = "circle";
    friend bool operator==(const CircleShape&, const CircleShape&) = default;
};
/// Of the area of the circle.
struct EllipseShape {
    static constexpr std::string_view name = "ellipse";
    double aspect_ratio = 0.0;  ///< major / minor semi-axis
    friend bool operator==(const EllipseShape&, const EllipseShape&) = default;
};
/// `radius` is its R₀.
struct BiconcaveShape {
    static constexpr std::string_view name = "biconcave";
    friend bool operator==(const BiconcaveShape&, const BiconcaveShape&) = default;
};
/// The points of an outline.
struct OutlineShape {
    static constexpr std::string_view name = "file";
    std::string file;                    ///< x,y in µm or pixels
    std::optional<Length> pixel;         ///< side of one, if the file is in pixels
    std::optional<bool> y_down;          ///< whether y counts downwards in the file
    std::optional<Length> smoothing;     ///< standard deviation along the outline
    std::optional<CellOutline> outline;  ///< what `file` holds; no key
    friend bool operator==(const OutlineShape&, const OutlineShape&) = default;
};

/// One cell in the middle.
struct SingleCell {
    static constexpr std::string_view name = "single";
    friend bool operator==(const SingleCell&, const SingleCell&) = default;
};
/// The paper's two rows.
struct PaperRows {
    static constexpr std::string_view name = "paper";
    Length perturbation{0.5e-6};  ///< largest random shift of each cell in x and y
    friend bool operator==(const PaperRows&, const PaperRows&) = default;
};
struct AtRandom {
    static constexpr std::string_view name = "random";
    friend bool operator==(const AtRandom&, const AtRandom&) = default;
};
struct AtPositions {
    static constexpr std::string_view name = "explicit";
    std::vector<std::vector<Length>> positions;  ///< [x, y] of each centre
    friend bool operator==(const AtPositions&, const AtPositions&) = default;
};

/// What a cell is, but for its membrane.
struct CellTypeCase {
    std::variant<CircleShape, EllipseShape, BiconcaveShape, OutlineShape> shape;
    Length radius{4e-6};  ///< circle; biconcave: R₀
    Angle angle;          ///< initial rotation, counter-clockwise
    std::optional<double>
        initial_stretch;  ///< start as an ellipse of this axis ratio, stress-free shape unchanged
    Viscosity cytoplasm_viscosity{6e-3};

    /// What the file of an outline holds; nothing for other shapes.
    const CellOutline* outline() const {
        const auto* shape_file = std::get_if<OutlineShape>(&shape);
        return shape_file && shape_file->outline ? &*shape_file->outline : nullptr;
    }
    friend bool operator==(const CellTypeCase&, const CellTypeCase&) = default;
};

struct CellsCase : CellTypeCase {
    std::optional<std::int64_t> count;
    std::optional<double> hematocrit;  ///< instead of count: Σ area / box area
    std::variant<SingleCell, PaperRows, AtRandom, AtPositions> layout;
    std::int64_t seed = 1;

    friend bool operator==(const CellsCase&, const CellsCase&) = default;
};

}  // namespace tt
