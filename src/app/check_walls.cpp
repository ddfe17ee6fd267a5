#include "app/check_walls.hpp"

#include <cmath>

#include "base/units.hpp"
#include "case/port_figures.hpp"
#include "case/walls_of.hpp"

namespace tt {
namespace {

/// What each port holds, and what of it plasma alone makes.
void print_ports(const Case& c, const Choice& choice) {
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        const PortFigures port = figures_of(c, choice, n);
        const LatticeOpening& place = choice.walls->openings[n];
        std::string text = fmt::format(
            "{}: {} wide, {} sites; pressure {}, flow rate {}, mean velocity {}{}", c.ports[n].name,
            rounded_text(port.width), place.width, rounded_text(port.pressure, 4),
            fmt::format("{:.4g} mm^2/s", 1e6 * port.flow_rate.si),
            fmt::format("{:.4g} mm/s", 1e3 * port.mean_velocity.si),
            c.ports[n].pressure ? "" : ", flow held");
        if (std::fabs(place.off) > 0.01)
            text += fmt::format("; {:.2f} sites off the middle between two sites", place.off);
        print_line(n == 0 ? "ports" : "", text);
    }
    print_line("late answer", late_answer_text(choice));
}

void print_sections(const Choice& choice) {
    for (std::size_t n = 0; n < choice.sections.size(); ++n) {
        const Section& section = choice.sections[n];
        const double width = section.line.width() * choice.dx.si;
        print_line(n == 0 ? "sections" : "",
                   fmt::format("{}: {} wide, {} sites", section.name,
                               rounded_text(Length{width}, 4), section.line.rows.size()));
    }
}

}  // namespace

void print_walls(const Case& c, const Choice& choice) {
    if (const auto* drawn = std::get_if<DrawnShape>(&c.geometry.shape))
        for (const auto& [label, text] : drawn->found) print_line(label, text);
    if (!choice.walls) return print_sections(choice);
    print_line("walls", fmt::format("{}; {}", word_of(c.geometry.shape),
                                    description(*choice.walls, choice.dx.si)));
    if (c.network()) {
        print_ports(c, choice);
        print_sections(choice);
        return;
    }
    print_sections(choice);
    // Of straight channels of this width the flow is off by 0.66/H² (docs/theory/walls.md).
    print_line("resistance",
               fmt::format("flow rate per force {:.4g} times that of the open box; expect {:.1g} % "
                           "of error from the walls",
                           12.0 * choice.undisturbed->conductance / std::pow(choice.ny, 3),
                           66.0 / std::pow(narrowest_gap(*choice.walls), 2)));
}

void print_feeds(const Case& c, const Model& model, const Appraisal& a) {
    for (std::size_t n = 0; n < model.feeds.size(); ++n) {
        const Feed& feed = model.feeds[n];
        const Scales& scales = model.scales;
        const double turn = feed.period / feed.channel->drive.target_velocity;  // of plasma
        const double per_second = a.feed_cells[n] / (turn * scales.time);
        print_line(
            n == 0 ? "feed" : "",
            fmt::format("{}: {} cells in a channel of {}, hematocrit {:.1f} %, {} sites; some {} "
                        "cells come in a second, {:.0f} in this run",
                        model.port_names[static_cast<std::size_t>(feed.port)], a.feed_cells[n],
                        rounded_text(Length{feed.period * scales.length}, 4),
                        100.0 * a.feed_cells[n] * a.cell_area / feed.channel->open_area(),
                        with_spaces(feed.channel->lattice.nx * feed.channel->lattice.ny),
                        rounded_text(per_second, Dimension{}, 2), per_second * c.time.end.si));
    }
}

}  // namespace tt
