#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fluid/section_line.hpp"

namespace tt {

struct Model;
struct State;

/// A line across a channel at which flow and cells are measured.
struct Section {
    std::string name;
    SectionLine line;
    bool drawn_backwards = false;  ///< its `from` is the upper or right end
    SectionReading plasma;         ///< of plasma alone; see UndisturbedFlow
};

/// Numbers of the sections around a place where a channel parts in two.
struct Fork {
    std::string name;
    int parent = 0;
    std::array<int, 2> daughters{};
};

/// A channel between two sections.
struct Stretch {
    std::string name;
    int from = 0, to = 0;
    double resistance = 0.0;  ///< Δp/Q of a fluid of viscosity 1
};

/// What went on at a section: readings of the last step and of the one before, and what has passed
/// since the start. Lattice units.
struct SectionState {
    std::array<double, 2> inflow{}, density{};
    std::array<std::vector<double>, 2> velocity;  ///< at each row of the line
    double volume = 0.0;                          ///< forward less backward [sites²]
    double area = 0.0;                            ///< of the cells counted, likewise
    std::int64_t forward = 0, backward = 0;       ///< cells
    /// Of each cell by its number: −1 before the line, 1 behind it, 0 not near.
    std::vector<std::int8_t> side;

    double mean_inflow() const { return 0.5 * (inflow[0] + inflow[1]); }
    double mean_density() const { return 0.5 * (density[0] + density[1]); }
    friend bool operator==(const SectionState&, const SectionState&) = default;
};

/// Way from a section to a place near it: along the line, and through it, forward positive. Of the
/// periodic images the nearest.
Vec2 from_section(const SectionLine& line, const Lattice& lattice, Vec2 place);

/// Notes what passed in the step just made. A cell has passed once its centroid is half a site
/// beyond the line, coming from half a site before it: one that wavers on the line is not counted
/// twice. Far from the line it is forgotten, so that one which goes round and comes again is
/// counted again. Team function, by sections.
void watch_sections(const Model& model, State& state);

/// Of what passes a line by its links to the flow rate, an integral: see Walls::sampled_flow.
double sampled_flow(const Model& model);

/// p on a section; where a force stands for the drop of pressure along the channels, with it.
double pressure_at(const Model& model, const State& state, std::size_t section);

/// Flow rate through a section.
double flow_rate_at(const Model& model, const State& state, std::size_t section);

}  // namespace tt
