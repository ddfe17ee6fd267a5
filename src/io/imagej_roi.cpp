#include "io/imagej_roi.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tt {
namespace {

// Places in the header.
constexpr std::size_t version_at = 4, type_at = 6, top_at = 8, left_at = 10, count_at = 16,
                      large_count_at = 18, composite_size_at = 36, options_at = 50,
                      coordinates_at = 64;
constexpr unsigned spline_fit = 1, parts_of_pixels = 128;
constexpr unsigned first_version_with_parts = 222;

constexpr std::array<std::string_view, 11> types{
    "polygon",  "rectangle", "oval",   "straight line", "freehand line", "segmented line",
    "no shape", "freehand",  "traced", "angle",         "points"};

class RoiReader {
public:
    RoiReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PointList read() const {
        if (bytes_.size() < coordinates_at) refuse("the ROI is cut short");
        const unsigned type = byte(type_at), options = u16(options_at);
        if (u32(composite_size_at) > 0) refuse_type("composite");
        if (type != 0 && type != 7 && type != 8)
            refuse_type(type < types.size() ? types[type] : "unknown type");
        if ((options & spline_fit) != 0)
            refuse(
                "the ROI is fitted by a spline and holds its knots only; in ImageJ choose Edit > "
                "Selection > Interpolate, and save it again");
        const bool parts =
            (options & parts_of_pixels) != 0 && u16(version_at) >= first_version_with_parts;
        const std::size_t count = u16(count_at) > 0 ? u16(count_at) : u32(large_count_at);
        if (count > most_points)
            refuse(fmt::format("an outline has at most {} points", most_points));
        return parts ? absolute(count) : relative(count);
    }

private:
    [[noreturn]] void refuse(std::string message) const {
        throw CaseError({{name_, 0, 0, std::move(message)}});
    }
    [[noreturn]] void refuse_type(std::string_view type) const {
        refuse(
            fmt::format("this is an ROI of type {}, which holds no outline; in ImageJ choose "
                        "Edit > Selection > Interpolate or Create Mask and the wand, and save "
                        "it as polygon, freehand or traced",
                        type));
    }

    /// Two bytes each, all x, then all y, from the upper left corner of the bounding box.
    PointList relative(std::size_t count) const {
        expect(coordinates_at + 4 * count);
        PointList list{{}, {}, "pixels", true};
        for (std::size_t k = 0; k < count; ++k)
            list.points.push_back({double(i16(left_at)) + i16(coordinates_at + 2 * k),
                                   double(i16(top_at)) + i16(coordinates_at + 2 * (count + k))});
        return list;
    }

    /// Behind those, four bytes each, as they are.
    PointList absolute(std::size_t count) const {
        const std::size_t begin = coordinates_at + 4 * count;
        expect(begin + 8 * count);
        PointList list{{}, {}, "pixels", true};
        for (std::size_t k = 0; k < count; ++k) {
            const Vec2 p{f32(begin + 4 * k), f32(begin + 4 * (count + k))};
            if (!(std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate))
                refuse(fmt::format("point {} is at no place of an image", k + 1));
            list.points.push_back(p);
        }
        return list;
    }

    void expect(std::size_t size) const {
        if (bytes_.size() < size)
            refuse(fmt::format("the ROI is cut short: it has {} bytes, and its points take {}",
                               bytes_.size(), size));
    }

    unsigned byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
    unsigned u16(std::size_t at) const { return byte(at) << 8 | byte(at + 1); }
    int i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
    std::uint32_t u32(std::size_t at) const { return u16(at) << 16 | u16(at + 2); }
    double f32(std::size_t at) const { return std::bit_cast<float>(u32(at)); }

    std::string_view bytes_;
    const std::string& name_;
};

}  // namespace

bool is_imagej_roi(std::string_view bytes) { return bytes.substr(0, 4) == "Iout"; }

PointList parse_imagej_roi(std::string_view bytes, const std::string& name) {
    return RoiReader(bytes, name).read();
}

}  // namespace tt
