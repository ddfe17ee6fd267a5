#include "membrane/suspension.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "base/contracts.hpp"

namespace tt {
namespace {

/// Turning 2 tan(θ/2) between two consecutive segments; second order in θ and without bound as they
/// fold.
double turning(Vec2 before, Vec2 after) {
    return 2.0 * cross(before, after) / (norm(before) * norm(after) + dot(before, after));
}

constexpr std::array per_node{
    &Suspension::x,           &Suspension::y,         &Suspension::fx,
    &Suspension::fy,          &Suspension::pair_fx,   &Suspension::pair_fy,
    &Suspension::ux,          &Suspension::uy,        &Suspension::ux_sampled,
    &Suspension::uy_sampled,  &Suspension::dipole_xx, &Suspension::dipole_xy,
    &Suspension::rate_xx,     &Suspension::rate_xy,   &Suspension::rest_curvature,
    &Suspension::rest_length, &Suspension::stiffness};
constexpr std::array per_cell{&Suspension::reference_area, &Suspension::reference_perimeter,
                              &Suspension::alpha, &Suspension::area, &Suspension::perimeter};

template <class Visit>
void for_each_per_node(Visit&& visit) {
    for (const auto array : per_node) visit(array);
    for (const CarriedLoad& load : carried_loads) visit(load.values);
}

void number_last(Suspension& cells) {
    cells.id.push_back(cells.id.empty() ? 0 : cells.id.back() + 1);
    cells.led.push_back(0);
}

}  // namespace

void size_derived(Suspension& cells) {
    for (auto* zero :
         {&cells.dipole_xx, &cells.dipole_xy, &cells.rate_xx, &cells.rate_xy, &cells.stiffness})
        zero->resize(cells.x.size(), 0.0);
}

void number_cells(Suspension& cells) {
    cells.id.resize(static_cast<std::size_t>(cells.cell_count()));
    std::iota(cells.id.begin(), cells.id.end(), 0);
    cells.led.assign(cells.id.size(), 0);
}

void remove_cell(Suspension& cells, int cell) {
    const int begin = cells.first[cell], end = cells.first[cell + 1];
    for_each_per_node([&](auto array) {
        (cells.*array).erase((cells.*array).begin() + begin, (cells.*array).begin() + end);
    });
    for (const auto array : per_cell) (cells.*array).erase((cells.*array).begin() + cell);
    cells.id.erase(cells.id.begin() + cell);
    cells.led.erase(cells.led.begin() + cell);
    cells.kind.erase(cells.kind.begin() + cell);
    cells.first.erase(cells.first.begin() + cell);
    for (int c = cell; c < static_cast<int>(cells.first.size()); ++c) cells.first[c] -= end - begin;
}

void copy_cell(const Suspension& from, int cell, Vec2 by, Suspension& to) {
    const int begin = from.first[cell], end = from.first[cell + 1], first = to.first.back();
    for_each_per_node([&](auto array) {
        (to.*array).insert((to.*array).end(), (from.*array).begin() + begin,
                           (from.*array).begin() + end);
    });
    for (const auto array : per_cell) (to.*array).push_back((from.*array)[cell]);
    to.kind.push_back(from.kind[cell]);
    to.first.push_back(first + end - begin);
    for (int n = first; n < to.first.back(); ++n) {
        to.x[n] += by.x;
        to.y[n] += by.y;
    }
    number_last(to);
}

void add_cell(Suspension& cells, const std::vector<Vec2>& points, int kind) {
    TT_EXPECTS(points.size() >= 8);
    const std::size_t n = points.size();
    double doubled_area = 0.0;
    double perimeter = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 here = points[k];
        const Vec2 after = points[(k + 1) % n] - here;
        const Vec2 before = here - points[(k + n - 1) % n];
        cells.x.push_back(here.x);
        cells.y.push_back(here.y);
        cells.rest_length.push_back(norm(after));
        cells.rest_curvature.push_back(turning(before, after) /
                                       (0.5 * (norm(before) + norm(after))));
        doubled_area += cross(here - points[0], after);
        perimeter += norm(after);
    }
    TT_EXPECTS(doubled_area > 0.0);
    cells.first.push_back(cells.first.back() + static_cast<std::int32_t>(n));
    for (auto* zero : {&cells.fx, &cells.fy, &cells.pair_fx, &cells.pair_fy, &cells.ux, &cells.uy,
                       &cells.ux_sampled, &cells.uy_sampled})
        zero->resize(cells.x.size(), 0.0);
    for (const CarriedLoad& load : carried_loads) (cells.*load.values).resize(cells.x.size(), 0.0);
    size_derived(cells);
    number_last(cells);
    cells.kind.push_back(kind);
    cells.reference_area.push_back(0.5 * doubled_area);
    cells.reference_perimeter.push_back(perimeter);
    cells.alpha.push_back(1.0);
    cells.area.push_back(0.5 * doubled_area);
    cells.perimeter.push_back(perimeter);
}

}  // namespace tt
