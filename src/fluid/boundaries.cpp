#include "fluid/boundaries.hpp"

namespace tt {
namespace {

/// The diagonal populations that return from the wall on side dy = −1 or 1 of row j.
template <class Real>
void drag(Populations<Real>& populations, int j, int dy, double speed) {
    const int nx = populations.lattice().nx;
    for (int i = 5; i < d2q9::count; ++i) {
        if (d2q9::cy[i] != -dy) continue;
        const double gain = 2.0 * d2q9::weight[i] * d2q9::cx[i] * speed / d2q9::sound_speed_squared;
        Real* const returning = populations.data() + populations.arrivals(i, j);
#pragma omp simd
        for (int x = 0; x < nx; ++x) returning[x] = static_cast<Real>(returning[x] + gain);
    }
}

/// The three populations that leave row j through its two ends.
template <class Real>
void drop_pressure(Populations<Real>& populations, int j, double pressure_drop) {
    const double density_drop = pressure_drop / d2q9::sound_speed_squared;
    const int outlet = populations.lattice().nx - 1;
    for (int i = 1; i < d2q9::count; ++i) {
        if (d2q9::cx[i] == 0 || populations.wall_between(j, d2q9::cy[i])) continue;
        const int x = d2q9::cx[i] > 0 ? outlet : 0;
        const double gain = d2q9::cx[i] * d2q9::weight[i] * density_drop;
        Real& departing = populations.data()[populations.departures(i, j) + x];
        departing = static_cast<Real>(departing + gain);
    }
}

}  // namespace

template <class Real>
void finish_departures(const Boundaries& boundaries, Populations<Real>& populations, int j) {
    if (populations.wall_between(j, -1) && boundaries.bottom_speed != 0.0) {
        drag(populations, j, -1, boundaries.bottom_speed);
    }
    if (populations.wall_between(j, 1) && boundaries.top_speed != 0.0) {
        drag(populations, j, 1, boundaries.top_speed);
    }
    if (boundaries.pressure_drop != 0.0) drop_pressure(populations, j, boundaries.pressure_drop);
}

template void finish_departures(const Boundaries&, Populations<double>&, int);
template void finish_departures(const Boundaries&, Populations<float>&, int);

}  // namespace tt
