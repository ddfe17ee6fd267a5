#include "simulation/sections.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "membrane/outline.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {
namespace {

/// As far from the line a cell is followed [sites]: no step moves it as far.
constexpr double near_line = 2.0;
/// A cell that comes from this far before the line and is as far beyond it has passed.
constexpr double threshold = 0.5;

template <class Real>
void read(const SectionLine& line, const Sites<Real>& sites, SectionState& s) {
    const SectionReading now = read_section(line, sites.populations);
    s.inflow = {now.inflow, s.inflow[0]};
    s.density = {now.density, s.density[0]};
    std::swap(s.velocity[0], s.velocity[1]);
    read_velocity(line, sites.velocity, s.velocity[0]);
    if (s.velocity[1].empty()) s.velocity[1] = s.velocity[0];
}

/// Of a cell whose centroid is this way from the line, and was on that side.
std::int8_t side_of(const SectionLine& line, Vec2 way, std::int8_t before) {
    const bool beside = way.x < line.begin || way.x > line.end;
    if (beside || std::fabs(way.y) > near_line) return 0;
    if (std::fabs(way.y) <= threshold && before != 0) return before;
    return way.y < 0.0 ? -1 : 1;
}

void count_cells(const Model& model, const SectionLine& line, const Suspension& cells,
                 SectionState& s) {
    for (int c = 0; c < cells.cell_count(); ++c) {
        const auto id = static_cast<std::size_t>(cells.id[c]);
        if (s.side.size() <= id) s.side.resize(id + 1, 0);
        std::int8_t& side = s.side[id];
        // No node is farther from the centroid than half of the perimeter.
        const Vec2 node = cells.position(cells.first[c]);
        const double way = from_section(line, model.lattice, node).y;
        if (std::fabs(way) > 0.5 * cells.perimeter[c] + 2.0 * near_line) {
            side = 0;
            continue;
        }
        const AreaMoments cell = area_moments(outline(cells, c));
        const Vec2 apart = from_section(line, model.lattice, cell.centroid);
        const std::int8_t now = side_of(line, apart, side);
        if (side * now < 0) {
            ++(now > 0 ? s.forward : s.backward);
            s.area += now * cell.area;
        }
        side = now;
    }
}

}  // namespace

Vec2 from_section(const SectionLine& line, const Lattice& lattice, Vec2 place) {
    const Vec2 apart = place - line.middle();
    const double x = std::remainder(apart.x, lattice.nx);
    const double y = lattice.walls ? apart.y : std::remainder(apart.y, lattice.ny);
    const double middle = 0.5 * (line.begin + line.end);
    return line.upright ? Vec2{middle + y, line.sign * x} : Vec2{middle + x, line.sign * y};
}

void watch_sections(const Model& model, State& state) {
    const double sampled = sampled_flow(model);
    const auto [begin, end] = team_share(static_cast<int>(model.sections.size()));
    for (int n = begin; n < end; ++n) {
        const SectionLine& line = model.sections[n].line;
        SectionState& s = state.sections[n];
        std::visit([&](const auto& sites) { read(line, sites, s); }, state.sites);
        s.volume += s.inflow[0] / sampled;
        count_cells(model, line, state.cells, s);
    }
    team_barrier();
}

double sampled_flow(const Model& model) {
    if (!model.boundaries.ports.empty()) return model.boundaries.walls->sampled_flow();
    if (model.undisturbed) return model.undisturbed->site_mean;
    return 1.0 + 0.5 / std::pow(model.lattice.ny, 2);
}

double pressure_at(const Model& model, const State& state, std::size_t section) {
    const double force = state.drive.body_force;
    const Vec2 middle = model.sections[section].line.middle();
    return state.sections[section].mean_density() * d2q9::sound_speed_squared -
           force * dot(model.drive.direction, middle);
}

double flow_rate_at(const Model& model, const State& state, std::size_t section) {
    return state.sections[section].mean_inflow() / sampled_flow(model);
}

}  // namespace tt
