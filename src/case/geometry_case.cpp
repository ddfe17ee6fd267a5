#include "case/geometry_case.hpp"

#include <type_traits>
#include <utility>

namespace tt {
namespace {

/// Of a shape whose keys could not all be read.
template <class S>
bool has_sizes(const S& shape) {
    bool sizes = true;
    for_each_field<S>([&](const auto& field) {
        const auto& value = shape.*field.member;
        if constexpr (requires { value.si; }) sizes = sizes && field.range.contains(value.si);
        if constexpr (requires { value.front().si; })
            for (const auto& item : value) sizes = sizes && field.range.contains(item.si);
    });
    return sizes;
}

}  // namespace

std::vector<std::string_view> GeometryCase::port_names() const {
    return std::visit(
        []<class S>(const S&) -> std::vector<std::string_view> {
            if constexpr (NetworkShape<S>) return S::ports();
            return {};
        },
        shape);
}

ShapeFaults GeometryCase::faults() const {
    return std::visit(
        []<class S>(const S& chosen) -> ShapeFaults {
            if constexpr (NetworkShape<S>) {
                if (!has_sizes(chosen)) return {};
                ShapeFaults faults = chosen.faults();
                if (!faults.empty()) return faults;
                if (const auto place = crossing_of(chosen.drawing().loops))
                    faults.emplace_back("shape", "channels overlap near (" + um(place->x) + ", " +
                                                     um(place->y) +
                                                     "); write longer or narrower ones, or "
                                                     "another angle");
                return faults;
            }
            return {};
        },
        shape);
}

std::optional<ShapeDrawing> GeometryCase::drawing() const {
    return std::visit(
        []<class S>(const S& chosen) -> std::optional<ShapeDrawing> {
            if constexpr (NetworkShape<S>) {
                if (has_sizes(chosen) && chosen.faults().empty()) return chosen.drawing();
            }
            return std::nullopt;
        },
        shape);
}

std::vector<Loop> GeometryCase::channels() const {
    if (const auto* drawn = std::get_if<DrawnShape>(&shape)) return drawn->loops;
    if (auto draws = drawing()) return std::move(draws->loops);
    return {};
}

}  // namespace tt
