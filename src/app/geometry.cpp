#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/check_walls.hpp"
#include "app/option_values.hpp"
#include "app/picture.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "case/drawn_file.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

struct GeometryOptions {
    std::string file, output, fluid;
    std::optional<std::string> layer, unit, pixel, chord;
    PictureOption picture;
};

std::optional<Length> length_of(const char* option, const std::optional<std::string>& text) {
    if (!text) return std::nullopt;
    try {
        const Measure m = parse_measure(*text);
        if (m.dimension == Length::dimension && m.si > 0.0) return Length{m.si};
    } catch (const UnitError&) {
    }
    throw CommandError(fmt::format("--{} {} is not a length; write for example --{} \"0.5 um\"",
                                   option, *text, option));
}

Side side_of(const GeometryOptions& options) {
    for (const Side side : {Side::inside, Side::outside, Side::bright, Side::dark})
        if (options.fluid == word_of(side)) return side;
    return Side::inside;
}

/// The drawing with its loops. CaseError where it cannot be read.
DrawnShape read_drawing(const GeometryOptions& options) {
    DrawnShape drawn;
    drawn.file = fs::absolute(options.file).lexically_normal().string();
    drawn.fluid = side_of(options);
    drawn.layer = options.layer;
    drawn.unit = length_of("unit", options.unit);
    drawn.pixel = length_of("pixel", options.pixel);
    drawn.chord = length_of("chord", options.chord);
    Case c;
    c.geometry.shape = drawn;
    if (const auto faults = read_drawn(c, {{"geometry.file", Fault{options.file, 0, 0, {}}}});
        !faults.empty())
        throw CaseError(faults);
    return std::get<DrawnShape>(c.geometry.shape);
}

int convert(const GeometryOptions& options) {
    expect_drawable(options.picture);
    const DrawnShape drawn = read_drawing(options);
    fmt::print("{}\n\n", options.file);
    for (const auto& [label, text] : drawn.found) print_line(label, text);
    if (drawn.found.empty()) {
        const auto [low, high] = corners_of(drawn.loops);
        print_line("loops", fmt::format("{}, from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) um",
                                        drawn.loops.size(), 1e6 * low.x, 1e6 * low.y, 1e6 * high.x,
                                        1e6 * high.y));
    }
    for (const std::string& remark : drawn.remarks)
        fmt::print("\n  * {}\n", wrapped(remark, 79, 4));
    if (!options.output.empty()) {
        if (!is_converted(drawn))
            throw CommandError(options.file + " holds points already; leave -o out");
        replace_file(options.output, drawn.bytes, Durability::process);
        fmt::print("\nwrote {}\n", options.output);
    }
    if (options.picture.wanted())
        fmt::print("\ndrew {}\n", draw_picture(options.picture, drawn,
                                               fs::path(options.file).filename().string()));
    return exit_code::done;
}

}  // namespace

void add_geometry(CLI::App& app, Action& action) {
    auto options = std::make_shared<GeometryOptions>();
    CLI::App* verb =
        app.add_subcommand("geometry", "read a chip file: what is in it, loops of its walls");
    verb->add_option("file", options->file, ".dxf, .svg, .gds, .png or points")
        ->required()
        ->type_name(value_kind::any_file);
    verb->add_option("--layer", options->layer, "with the channels: a name, 1/0 of GDSII, an id")
        ->type_name(value_kind::name);
    verb->add_option("--unit", options->unit, "of the drawing, \"1 mm\"; else what the file says")
        ->type_name(value_kind::length);
    verb->add_option("--pixel", options->pixel, "side of a pixel of a mask, \"0.5 um\"")
        ->type_name(value_kind::length);
    verb->add_option("--chord", options->chord,
                     "how far chords may be off curves; else \"0.02 um\"")
        ->type_name(value_kind::length);
    add_choice(*verb, "--fluid", options->fluid,
               {{"inside", ""}, {"outside", ""}, {"bright", ""}, {"dark", ""}},
               "of drawings or masks");
    verb->add_option("-o,--output", options->output, "write the loops there: x,y in um")
        ->type_name(value_kind::any_file);
    add_picture_option(*verb, options->picture);
    verb->footer(
        "A case reads such files itself: file = \"chip.dxf\" in [geometry], with the same\n"
        "keys. What is written can stand in the place of the drawing, where Python is\n"
        "missing; beside it, as chip.dxf.loops.csv, it is taken as long as the drawing\n"
        "is the same. Fluid is inside or outside of outlines, and where a mask is bright\n"
        "or dark.\n\n"
        "  tanktread geometry chip.dxf --layer CHANNELS --picture\n"
        "  tanktread geometry mask.png --pixel \"0.5 um\" --fluid bright -o walls.csv");
    verb->callback([options, &action] { action = [options] { return convert(*options); }; });
}

}  // namespace tt
