#include "fluid/collide_stream.hpp"

#include "base/contracts.hpp"
#include "base/parallel.hpp"
#include "fluid/collide_row.hpp"

namespace tt {

void collide_and_stream(const Equilibrium& equilibrium, const Boundaries& boundaries,
                        Vec2 body_force, const VectorField& force, const Relaxation& relaxation,
                        Populations& populations, VectorField& velocity) {
    const Lattice& lattice = populations.lattice();
    TT_EXPECTS(force.x.lattice() == lattice && velocity.x.lattice() == lattice);
    TT_EXPECTS(relaxation.even.lattice() == lattice && relaxation.odd.lattice() == lattice);
    RowOfSites row{};
    row.count = lattice.nx;
    row.body_force = body_force;
    const auto [begin, end] = team_share(lattice.ny);
    for (int j = begin; j < end; ++j) {
        for (int i = 0; i < d2q9::count; ++i) row.at[i] = populations.arrivals(i, j);
        row.force_x = force.x.row(j);
        row.force_y = force.y.row(j);
        row.even = relaxation.even.row(j);
        row.odd = relaxation.odd.row(j);
        row.velocity_x = velocity.x.row(j);
        row.velocity_y = velocity.y.row(j);
        std::visit([&](auto kind) { collide_row(kind, row); }, equilibrium);
        finish_departures(boundaries, populations, j);
    }
    team_barrier();
}

}  // namespace tt
