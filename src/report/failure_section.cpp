#include "report/failure_section.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/undefined.hpp"
#include "base/vec2.hpp"
#include "report/frames.hpp"
#include "report/html.hpp"

namespace tt {
namespace {

/// A part of the box to draw [m], y upwards.
struct View {
    double left, bottom, width, height;
    bool holds(Vec2 p) const {
        return p.x >= left && p.x <= left + width && p.y >= bottom && p.y <= bottom + height;
    }
};

/// The failing place [m]; nan where there is none.
Vec2 place_of(const Json& failure) {
    const auto number = [&](const char* key) {
        const auto found = failure.find(key);
        return found != failure.end() && found->is_number() ? found->get<double>() : undefined;
    };
    return {number("x"), number("y")};
}

/// Nodes of one cell [m], moved by whole boxes so that the first sound one lies in the box. In the
/// failing state some are anywhere, or not numbers: those are nan.
std::vector<Vec2> sound_nodes(const FramesHeader& header, const Frame& frame, int cell) {
    std::vector<Vec2> nodes;
    double shift = undefined;
    const double farthest = 1e6 * header.length;
    for (int k = header.first[cell]; k < header.first[cell + 1]; ++k) {
        const Vec2 p{frame.nodes[2 * k], frame.nodes[2 * k + 1]};
        const bool sound = std::abs(p.x) < farthest && std::abs(p.y) < 2.0 * header.width;
        if (sound && !std::isfinite(shift)) shift = header.length * std::floor(p.x / header.length);
        nodes.push_back(sound ? Vec2{p.x - shift, p.y} : Vec2{undefined, undefined});
    }
    return nodes;
}

/// An outline as an SVG path in µm, y downwards; it breaks at nodes that are nan.
std::string path_of(const std::vector<Vec2>& nodes, double shift, double height) {
    std::string path;
    bool pen_down = false;
    for (std::size_t k = 0; k <= nodes.size(); ++k) {
        const Vec2 p = nodes[k % nodes.size()];
        const bool sound = std::isfinite(p.x);
        if (sound)
            path += fmt::format("{}{:.3f} {:.3f}", pen_down ? "L" : "M", (p.x + shift) * 1e6,
                                (height - p.y) * 1e6);
        pen_down = sound;
    }
    return path;
}

/// All outlines of a frame that reach into the view, at both ends where they cross one.
std::string outlines(const FramesHeader& header, const Frame& frame, const View& view) {
    std::string paths;
    for (int cell = 0; cell < cell_count(header); ++cell) {
        const std::vector<Vec2> nodes = sound_nodes(header, frame, cell);
        for (const double shift : {-header.length, 0.0, header.length}) {
            bool seen = false;
            for (const Vec2 p : nodes) seen = seen || view.holds({p.x + shift, p.y});
            if (seen) paths += path_of(nodes, shift, header.width);
        }
    }
    return paths;
}

std::string picture(const FramesReader& frames, Vec2 place, const View& view,
                    std::string_view words) {
    const FramesHeader& header = frames.header();
    const double line = 0.003e6 * std::max(view.width, view.height);  // µm
    std::string svg = fmt::format(
        "<figure><svg role=\"img\" aria-label=\"{}\" viewBox=\"{:.3f} {:.3f} {:.3f} {:.3f}\" "
        "style=\"width:100%;max-height:24rem;border:1px solid #8c8c8c\" fill=\"none\" "
        "stroke-width=\"{:.4f}\">",
        html(words), view.left * 1e6, (header.width - view.bottom - view.height) * 1e6,
        view.width * 1e6, view.height * 1e6, line);
    const int last = frames.count() - 1;
    if (last > 0)
        svg += fmt::format("<path stroke=\"#9a9a9a\" d=\"{}\"/>",
                           outlines(header, frames.frame(0), view));
    svg += fmt::format("<path stroke=\"#0072b2\" d=\"{}\"/>",
                       outlines(header, frames.frame(last), view));
    if (std::isfinite(place.x) && std::isfinite(place.y))
        svg += fmt::format(
            "<circle class=\"failing\" stroke=\"#c8372d\" stroke-width=\"{:.4f}\" cx=\"{:.3f}\" "
            "cy=\"{:.3f}\" r=\"{:.4f}\"/>",
            2.0 * line, place.x * 1e6, (header.width - place.y) * 1e6, 6.0 * line);
    return svg + fmt::format("</svg><figcaption>{}</figcaption></figure>\n", html(words));
}

std::string pictures(const Results& run) {
    const FramesHeader& header = run.failing->header();
    const Vec2 place = place_of(run.failure);
    const int last = run.failing->count() - 1;
    const std::string times =
        last > 0 ? fmt::format(
                       "Blue: the failing state, t = {:.6g} ms; grey: the last good one, "
                       "t = {:.6g} ms.",
                       1e3 * run.failing->time(last), 1e3 * run.failing->time(0))
                 : "Blue: the failing state.";
    std::string text = "<div class=\"figures\">\n";
    text += picture(*run.failing, place, {0.0, 0.0, header.length, header.width},
                    "The box when the run failed, the place marked in red. " + times);
    if (std::isfinite(place.x) && std::isfinite(place.y)) {
        const double side = 24.0 * header.dx;
        text +=
            picture(*run.failing, place, {place.x - 0.5 * side, place.y - 0.5 * side, side, side},
                    fmt::format("The same, {:.3g} µm around the place.", side * 1e6));
    }
    return text + "</div>\n";
}

}  // namespace

std::string failure_section(const Results& run, const std::string& label, std::string_view id) {
    if (run.failure.empty() && run.why.empty()) return "";
    std::string text =
        heading(id, "Why " + label + " failed") + fmt::format("<pre>{}</pre>\n", html(run.why));
    if (run.failing && run.failing->count() > 0) text += pictures(run);
    return text + "<p class=\"soft\">What follows is the history up to there.</p>\n";
}

}  // namespace tt
