#include "fluid/collide_stream.hpp"

#include "base/contracts.hpp"
#include "base/parallel.hpp"
#include "fluid/collide_row.hpp"

namespace tt {

template <class Real>
void collide_and_stream(const Equilibrium& equilibrium, const Boundaries& boundaries,
                        Vec2 body_force, const VectorField<Real>& force,
                        const Relaxation<Real>& relaxation, Populations<Real>& populations,
                        VectorField<Real>& velocity) {
    const Lattice& lattice = populations.lattice();
    TT_EXPECTS(force.x.lattice() == lattice && velocity.x.lattice() == lattice);
    TT_EXPECTS(relaxation.even.lattice() == lattice && relaxation.odd.lattice() == lattice);
    RowOfSites<Real> row{};
    row.body_force = body_force;
    const Walls* const walls = boundaries.walls.get();
    const OpenRun whole{0, lattice.nx};
    const auto [begin, end] = own_rows(lattice);
    // Upwards and downwards in turn: the rows of the end of one pass, still in the cache, are
    // the first of the next. The order of sites does not matter to an update in place.
    const bool upwards = populations.phase == Phase::even;
    for (int n = 0; n < end - begin; ++n) {
        const int j = upwards ? begin + n : end - 1 - n;
        const OpenRun* const runs = walls ? walls->runs.data() : &whole;
        const int first = walls ? walls->first_run[j] : 0;
        const int past = walls ? walls->first_run[j + 1] : 1;
        for (int r = first; r < past; ++r) {
            const int x = runs[r].begin;
            row.count = runs[r].end - x;
            for (int i = 0; i < d2q9::count; ++i)
                row.at[i] = populations.data() + populations.arrivals(i, j) + x;
            row.force_x = force.x.row(j) + x;
            row.force_y = force.y.row(j) + x;
            row.even = relaxation.even.row(j) + x;
            row.odd = relaxation.odd.row(j) + x;
            row.velocity_x = velocity.x.row(j) + x;
            row.velocity_y = velocity.y.row(j) + x;
            std::visit([&](auto kind) { collide_row(kind, row); }, equilibrium);
        }
        finish_departures(boundaries, populations, j);
    }
}

template void collide_and_stream(const Equilibrium&, const Boundaries&, Vec2,
                                 const VectorField<double>&, const Relaxation<double>&,
                                 Populations<double>&, VectorField<double>&);
template void collide_and_stream(const Equilibrium&, const Boundaries&, Vec2,
                                 const VectorField<float>&, const Relaxation<float>&,
                                 Populations<float>&, VectorField<float>&);

}  // namespace tt
