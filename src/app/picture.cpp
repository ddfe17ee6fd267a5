#include "app/picture.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/option_values.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "case/openings.hpp"
#include "case/port_figures.hpp"
#include "case/walls_of.hpp"
#include "report/figure_case.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

std::string held_by(const PortCase& port) {
    const std::string held =
        port.pressure        ? "pressure " + rounded_text(*port.pressure, 4)
        : port.flow_rate     ? fmt::format("flow rate {:.4g} mm^2/s", 1e6 * port.flow_rate->si)
        : port.mean_velocity ? "mean velocity " + rounded_text(*port.mean_velocity, 4)
                             : std::string("nothing held");
    return port.name + ": " + held;
}

/// The box is that of the drawing with a little around it.
void frame_drawing(const std::vector<Loop>& loops, CasePicture& picture) {
    const Corners corners = corners_of(loops);
    const double around = 0.02 * norm(corners.high - corners.low);
    picture.low = corners.low - Vec2{around, around};
    picture.high = corners.high + Vec2{around, around};
}

/// That of a network, else [domain].
void set_box(const Case& c, CasePicture& picture) {
    picture.high = {c.domain.length.si, c.domain.width.si};
    if (c.network()) frame_drawing(std::get<DrawnShape>(c.geometry.shape).loops, picture);
}

std::string drawn_to(const PictureOption& option, const CasePicture& picture) {
    const std::string file = option.file.empty() ? picture.title + ".png" : option.file;
    draw_case(picture, file);
    return file;
}

void add_walls(const Case& c, CasePicture& picture) {
    const Vec2 size = picture.high - picture.low;
    const Solid solid = moved(solid_of(c), -1.0 * picture.low);
    picture.side_walls = c.domain.sides == Sides::walls && !c.network();
    if (solid.empty()) return;
    picture.solid = solid_loops(solid, size.x, size.y);
    for (Loop& loop : picture.solid)
        for (Vec2& p : loop) p += picture.low;
}

void add_ports(const Case& c, const Choice* choice, CasePicture& picture) {
    if (!c.network()) return;
    const PortPlaces places = port_places(c);
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        CasePicture::Port port{places.openings[n], {}, held_by(c.ports[n])};
        if (choice) {
            const LatticeOpening& open = choice->walls->openings[n];
            const double sign = figures_of(c, *choice, n).flow_rate.si < 0.0 ? 1.0 : -1.0;
            port.along =
                sign * Vec2{static_cast<double>(open.out_x), static_cast<double>(open.out_y)};
        }
        picture.ports.push_back(std::move(port));
    }
}

/// Each cell wherever it shows in the box.
void add_cells(const Case& c, const Model& model, const State& initial, CasePicture& picture) {
    const Vec2 size = picture.high - picture.low;
    for (int n = 0; n < initial.cells.cell_count(); ++n) {
        const Outline nodes = outline(initial.cells, n);
        Loop loop;
        for (int k = 0; k < nodes.size(); ++k)
            loop.push_back(model.scales.length * (nodes[k] + model.origin));
        const Corners own = corners_of({loop});
        const auto shows = [&](Vec2 by) {
            return own.high.x + by.x > picture.low.x && own.low.x + by.x < picture.high.x &&
                   own.high.y + by.y > picture.low.y && own.low.y + by.y < picture.high.y;
        };
        for (const double right : {0.0, -size.x, size.x})
            for (const double up : {0.0, -size.y, size.y}) {
                if (!shows({right, up}) || (c.network() && (right != 0.0 || up != 0.0))) continue;
                Loop image = loop;
                for (Vec2& p : image) p += Vec2{right, up};
                picture.cells.push_back(std::move(image));
            }
    }
}

}  // namespace

void add_picture_option(CLI::App& verb, PictureOption& option) {
    option.option =
        verb.add_option("--picture", option.file, "draw it, to this .png or .svg; else to NAME.png")
            ->expected(0, 1)
            ->type_name(value_kind::any_file);
}

bool PictureOption::wanted() const { return option != nullptr && option->count() > 0; }

void expect_drawable(const PictureOption& option) {
    if (!option.wanted()) return;
    if (!can_draw()) throw IoError(std::string(no_gnuplot));
    if (!option.file.empty() && !is_picture_name(option.file))
        throw CommandError(fmt::format(
            "--picture {} is no name of a picture; write a name that ends in .png or .svg",
            option.file));
}

std::string draw_picture(const PictureOption& option, const Case& c, const Choice* choice,
                         const Model* model, const State* initial) {
    CasePicture picture;
    picture.title = c.name;
    set_box(c, picture);
    add_walls(c, picture);
    add_ports(c, choice, picture);
    if (model && initial) add_cells(c, *model, *initial, picture);
    return drawn_to(option, picture);
}

std::string draw_picture(const PictureOption& option, const DrawnShape& drawn,
                         const std::string& name) {
    CasePicture picture;
    picture.title = name;
    frame_drawing(drawn.loops, picture);
    picture.solid = drawn.loops;
    const auto [low, high] = std::pair(picture.low, picture.high);
    if (drawn.fluid != Side::outside)
        picture.solid.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
    return drawn_to(option, picture);
}

}  // namespace tt
