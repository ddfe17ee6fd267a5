#pragma once

#include <algorithm>
#include <chrono>

#include "base/isa.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/populations.hpp"
#include "fluid/relaxation.hpp"

/// The roof beside which benchmarks stand, what this machine's memory allows at the moment: an
/// update in place of all that the fluid pass touches (nine planes read and written, force and
/// rates read, velocity written) with next to no arithmetic.
namespace tt {

/// The arrays of a fluid pass.
template <class Real>
struct Flow {
    VectorField<Real> force;
    VectorField<Real> velocity;
    Relaxation<Real> relaxation;
    Populations<Real> populations;

    explicit Flow(const Lattice& lattice)
        : force(lattice), velocity(lattice), relaxation(lattice), populations(lattice) {
        Random random(1);
        for (int j = 0; j < lattice.ny; ++j) {
            for (int i = 0; i < lattice.nx; ++i) {
                force.x(i, j) = static_cast<Real>(random.uniform(-1e-5, 1e-5));
                force.y(i, j) = static_cast<Real>(random.uniform(-1e-5, 1e-5));
                const double even = random.uniform(0.5, 1.5);
                relaxation.even(i, j) = static_cast<Real>(even);
                relaxation.odd(i, j) = static_cast<Real>(Trt{}.odd_rate(even));
            }
        }
    }
};

template <class Real>
struct RowOfArrays {
    Real* plane[d2q9::count];
    const Real *force_x, *force_y, *even, *odd;
    Real *velocity_x, *velocity_y;
};

template <class Real>
TT_INLINE void update(const RowOfArrays<Real>& row, int count) {
    const auto [p0, p1, p2, p3, p4, p5, p6, p7, p8] = row.plane;
    const auto [plane, force_x, force_y, even, odd, velocity_x, velocity_y] = row;
    const auto scale = [](Real& f, Real by) { f *= by; };
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const Real a = even[i];
        const Real b = odd[i];
        velocity_x[i] = a * force_x[i];
        velocity_y[i] = b * force_y[i];
        scale(p0[i], a), scale(p1[i], b), scale(p2[i], a), scale(p3[i], b), scale(p4[i], a);
        scale(p5[i], b), scale(p6[i], a), scale(p7[i], b), scale(p8[i], a);
    }
}

[[maybe_unused]] static TT_CLONES void update_row(const RowOfArrays<double>& row, int count) {
    update(row, count);
}
[[maybe_unused]] static TT_CLONES void update_row(const RowOfArrays<float>& row, int count) {
    update(row, count);
}

/// Arrays to be updated as often as one likes: with rates of one they stay as they are.
template <class Real>
Flow<Real> roof_of(const Lattice& lattice) {
    Flow<Real> flow(lattice);
    flow.relaxation = Relaxation<Real>(lattice);
    return flow;
}

/// Two updates of everything the pass touches. Team function.
template <class Real>
void update_twice(Flow<Real>& flow) {
    const Lattice& lattice = flow.populations.lattice();
    const auto [begin, end] = team_share(lattice.ny);
    for (int pass = 0; pass < 2; ++pass) {
        for (int j = begin; j < end; ++j) {
            RowOfArrays<Real> row{{},
                                  flow.force.x.row(j),
                                  flow.force.y.row(j),
                                  flow.relaxation.even.row(j),
                                  flow.relaxation.odd.row(j),
                                  flow.velocity.x.row(j),
                                  flow.velocity.y.row(j)};
            for (int k = 0; k < d2q9::count; ++k)
                row.plane[k] = flow.populations.data() + flow.populations.row(k, j);
            update_row(row, lattice.nx);
        }
        team_barrier();
    }
}

/// Seconds of the fastest of the repetitions of `f` seen so far.
class Best {
public:
    template <class F>
    double time(F&& f) {
        const auto start = std::chrono::steady_clock::now();
        f();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        seconds_ = std::min(seconds_, elapsed.count());
        return elapsed.count();
    }
    double seconds() const { return seconds_; }

private:
    double seconds_ = 1e300;
};

}  // namespace tt
