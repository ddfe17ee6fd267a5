#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "coupling/jump.hpp"
#include "exchange/periodic.hpp"
#include "fluid/moments.hpp"
#include "membrane/suspension.hpp"
#include "observe/run_case.hpp"
#include "simulation/derive.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// Of a whole small run: it takes a tenth of a second and more, so that a stop can come after 20
/// to 50 ms.
inline constexpr std::int64_t small_steps = 6001;

/// Two cells in a small sheared box, some milliseconds of a thousand steps a second of wall time:
/// for tests of what a run does around its steps.
inline Model small_model() {
    Model model;
    model.lattice = Lattice{33, 24, true};
    model.scales = Scales{5e-7, 1e-6, 1025.0 * 1.25e-19};
    model.boundaries = Boundaries{-0.02, 0.02, 0.0};
    model.viscosity.plasma = 0.3;
    model.viscosity.cytoplasm = {0.6};
    model.kinds[0].jump =
        jump_correction(model.delta, model.viscosity.plasma, model.viscosity.cytoplasm[0]);
    model.kinds[0].membrane.in_plane = NeoHookean{2e-3};
    model.kinds[0].membrane.area_stiffness = 0.02;
    model.kinds[0].membrane.hold_area = true;
    model.shear_rate = 0.04 / 24;
    return model;
}

/// The same with a post between the cells and their periodic images.
inline Model with_post(Model model) {
    Solid solid;
    solid.period_x = model.lattice.nx;
    if (!model.lattice.walls) solid.period_y = model.lattice.ny;
    solid.loops = {{{15.6, 8.2}, {19.1, 10.4}, {18.3, 16.9}, {15.2, 14.7}}};
    model.boundaries.walls = std::make_shared<const Walls>(make_walls(solid, model.lattice));
    model.contact.walls = model.boundaries.walls;
    return model;
}

inline std::vector<Vec2> circle(Vec2 centre, double radius, int nodes) {
    std::vector<Vec2> points;
    for (int k = 0; k < nodes; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / nodes;
        points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return points;
}

inline State small_state(const Model& model) {
    State state;
    add_cell(state.cells, circle({9.3, 11.6}, 4.4, 36));
    add_cell(state.cells, circle({24.8, 13.1}, 3.9, 32));
    state.sites = sites_at_rest(model.lattice, model.precision);
    derive(model, state);
    return state;
}

/// What the sites of a state in double hold.
inline Sites<double>& in_double(State& state) { return std::get<Sites<double>>(state.sites); }

/// `steps` steps into `directory`, a row of series.csv every 10 and a frame every 25.
inline RunRequest small_request(const std::filesystem::path& directory, std::int64_t steps) {
    const double dt = small_model().scales.time;
    RunRequest request;
    request.directory = directory;
    request.name = "small";
    request.settings = "flow.shear_rate = \"75 /s\"\n";
    request.case_toml = "name = \"small\"\n";
    request.resolved_toml = "name = \"small\"\n# resolved\n";
    request.end = Time{static_cast<double>(steps) * dt};
    request.average_from = Time{0.5 * request.end.si};
    request.series = Time{10 * dt};
    request.frames = Time{25 * dt};
    request.progress = ProgressMode::none;
    return request;
}

inline RunOutcome run_small(const RunRequest& request, const Model& model = small_model()) {
    Periodic exchange;
    return run_case(
        request, model, [&] { return small_state(model); }, exchange);
}

}  // namespace tt
