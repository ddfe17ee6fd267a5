#include "case/drawn_file.hpp"

#include <fmt/format.h>

#include "case/walls_of.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

std::optional<double> in_um(const std::optional<Length>& length) {
    return length ? std::optional(length->si * 1e6) : std::nullopt;
}

/// Keys of [geometry] that mean nothing for this kind of file, and those that it needs.
std::vector<Fault> judge_keys(const DrawnShape& drawn, DrawingKind kind, const Places& places) {
    std::vector<Fault> faults;
    const auto tell = [&](const char* key, std::string message) {
        const auto given = places.find(fmt::format("geometry.{}", key));
        faults.push_back(given != places.end() ? given->second : places.at("geometry.file"));
        faults.back().message = std::move(message);
    };
    const std::string name = fs::path(drawn.file).filename().string();
    if (kind == DrawingKind::unknown)
        tell("file", fmt::format("{} is of no kind that is read: points (.csv, .txt), DXF (.dxf), "
                                 "SVG (.svg), GDSII (.gds) or a mask (.png); save it as one",
                                 name));
    const bool png = kind == DrawingKind::png, points = kind == DrawingKind::points;
    const auto forbid = [&](const char* key, bool given, bool of_no_use) {
        if (given && of_no_use)
            tell(key, fmt::format("{} means nothing for {}; leave it out", key, name));
    };
    forbid("layer", drawn.layer.has_value(), png || points);
    forbid("chord", drawn.chord.has_value(), points);
    forbid("pixel", drawn.pixel.has_value(), !png);
    if (png && drawn.unit)
        tell("unit", "unit means nothing for a picture; write pixel = \"0.5 um\", the side of one");
    const bool shade = drawn.fluid == Side::bright || drawn.fluid == Side::dark;
    if (shade && !png)
        tell("fluid", fmt::format("fluid = \"{}\" is for pictures; write \"inside\" or \"outside\"",
                                  word_of(drawn.fluid)));
    if (png && !shade)
        tell("fluid", "which part of the picture is fluid? write fluid = \"bright\" or \"dark\"");
    if (png && !drawn.pixel)
        tell("pixel",
             "a picture has no unit of length; write pixel = \"0.5 um\", the side of a "
             "pixel");
    return faults;
}

/// The loops of a drawing that are kept beside it; empty where there are none of this drawing, read
/// in this way.
std::string kept(const fs::path& file, const ChipDrawing& drawing) {
    const fs::path beside = kept_loops(file);
    std::error_code error;
    if (!fs::is_regular_file(beside, error)) return {};
    std::string text = read_file(beside, Author::user);
    return text.starts_with(chip_heading(drawing)) ? text : std::string{};
}

void convert(DrawnShape& drawn) {
    const fs::path file = drawn.file;
    drawn.original = std::move(drawn.bytes);
    const ChipDrawing drawing{shown(file),         drawn.original,     drawn.layer,
                              in_um(drawn.unit),   in_um(drawn.pixel), in_um(drawn.chord),
                              word_of(drawn.fluid)};
    drawn.bytes = kept(file, drawing);
    if (!drawn.bytes.empty()) {
        drawn.found = {{"drawing", fmt::format("loops kept in {}", shown(kept_loops(file)))}};
        return;
    }
    ChipLoops loops = read_chip(drawing);
    drawn.bytes = std::move(loops.csv);
    drawn.found = std::move(loops.found);
    drawn.remarks = std::move(loops.remarks);
}

}  // namespace

std::vector<Fault> read_drawn(Case& c, const Places& places) {
    auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape);
    if (!drawn || drawn->file.empty()) return {};
    const DrawingKind kind = drawing_kind(drawn->file);
    if (auto faults = judge_keys(*drawn, kind, places); !faults.empty()) return faults;
    try {
        const fs::path path = drawn->file;
        drawn->bytes = read_file(path, Author::user);
        if (kind != DrawingKind::points) convert(*drawn);
        const double unit =
            kind == DrawingKind::points ? drawn->unit.value_or(Length{1e-6}).si : 1e-6;
        drawn->loops = read_loops(drawn->bytes, shown(path), unit);
    } catch (const CaseError& error) {
        return error.faults();
    } catch (const IoError& error) {
        Fault fault = places.at("geometry.file");
        fault.message = fmt::format("{}; file names the loops of walls", error.what());
        return {fault};
    }
    return {};
}

bool is_converted(const DrawnShape& drawn) { return !drawn.original.empty(); }

fs::path kept_loops(const fs::path& drawing) { return drawing.string() + ".loops.csv"; }

DrawnShape as_points(DrawnShape drawn) {
    if (!is_converted(drawn)) return drawn;
    drawn.layer.reset();
    drawn.unit.reset();
    drawn.pixel.reset();
    drawn.chord.reset();
    if (drawn.fluid != Side::outside) drawn.fluid = Side::inside;  // of what is bright or dark
    drawn.file = kept_loops(drawn.file).string();
    return drawn;
}

std::string shown(const fs::path& path) {
    std::error_code error;
    const fs::path from_here = path.lexically_relative(fs::current_path(error));
    const bool below = !error && !from_here.empty() && *from_here.begin() != "..";
    return (below ? from_here : path).string();
}

}  // namespace tt
