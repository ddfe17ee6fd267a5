#include "fluid/moments.hpp"

namespace tt {

template <class Real>
Moments moments(const Populations<Real>& populations, int i, int j) {
    Moments m;
    for (int k = 0; k < d2q9::count; ++k) {
        const double f = populations.arriving(k, i, j);
        m.density_deviation += f;
        m.momentum += f * Vec2{double(d2q9::cx[k]), double(d2q9::cy[k])};
        m.xx += f * d2q9::cx[k] * d2q9::cx[k];
        m.xy += f * d2q9::cx[k] * d2q9::cy[k];
        m.yy += f * d2q9::cy[k] * d2q9::cy[k];
    }
    return m;
}

template <class Real>
std::vector<double> density_deviations(const Populations<Real>& populations, int j) {
    std::vector<double> sums(static_cast<std::size_t>(populations.lattice().nx), 0.0);
    for (int k = 0; k < d2q9::count; ++k) {
        const Real* const arriving = populations.data() + populations.arrivals(k, j);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += arriving[i];
    }
    return sums;
}

template <class Real>
void set_equilibrium(const Equilibrium& equilibrium, const VectorField<>& velocity,
                     const Field<>& density, Populations<Real>& populations) {
    const Lattice& lattice = populations.lattice();
    populations.phase = Phase::even;
    std::visit(
        [&](auto kind) {
            for (int k = 0; k < d2q9::count; ++k) {
                for (int j = 0; j < lattice.ny; ++j) {
                    for (int i = 0; i < lattice.nx; ++i) {
                        populations.set_slot(k, i, j,
                                             population(kind, k, density(i, j), velocity(i, j)));
                    }
                }
            }
        },
        equilibrium);
}

template Moments moments(const Populations<double>&, int, int);
template Moments moments(const Populations<float>&, int, int);
template std::vector<double> density_deviations(const Populations<double>&, int);
template std::vector<double> density_deviations(const Populations<float>&, int);
template void set_equilibrium(const Equilibrium&, const VectorField<>&, const Field<>&,
                              Populations<double>&);
template void set_equilibrium(const Equilibrium&, const VectorField<>&, const Field<>&,
                              Populations<float>&);

}  // namespace tt
