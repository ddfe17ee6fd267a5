#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "coupling/delta/delta.hpp"
#include "coupling/stencil.hpp"
#include "coupling/viscosity_mean.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"

/// Measures what KernelSpread states: two straight membranes in direction t through a periodic box,
/// cytoplasm between them, a tangential load f and a dipole d (t n + n t) on the nodes. Nothing
/// varies along t, so the exact flow is a shear on either side; what the membrane smeared by kernel
/// and lattice does to it is read off straight lines through the fluid beyond the kernel's reach.
namespace tt {
namespace {

constexpr double plasma = 1.0 / 3.0;

struct Strip {
    double tx, ty;  ///< direction of the membranes; n = (−t_y, t_x) points into the strip
    double period;  ///< of the box along n
    double width;   ///< of the strip
    double from;    ///< n of its first membrane

    Strip(int p, int q, int box, double share, double from_)
        : tx(p / std::hypot(p, q)),
          ty(q / std::hypot(p, q)),
          period(box / std::hypot(p, q)),
          width(share * period),
          from(from_) {}

    /// n of a point beyond the first membrane, 0 … period.
    double depth(Vec2 at) const {
        const double n = -ty * at.x + tx * at.y - from;
        return n - period * std::floor(n / period);
    }
};

/// Area of the unit square at distance d inside a half plane, by its corners cut off.
double half_plane_fraction(double d, const Strip& strip) {
    const double a = std::fabs(strip.tx), b = std::fabs(strip.ty);
    const auto corner = [](double s) { return s > 0.0 ? 0.5 * s * s : 0.0; };
    const double s = d + 0.5 * (a + b);
    if (std::min(a, b) < 1e-12) return std::clamp(s, 0.0, 1.0);
    return (corner(s) - corner(s - a) - corner(s - b) + corner(s - a - b)) / (a * b);
}

double fraction(Vec2 site, const Strip& strip) {
    const double n = strip.depth(site);
    const double nearest = n > 0.5 * (strip.width + strip.period) ? n - strip.period : n;
    return half_plane_fraction(std::min(nearest, strip.width - nearest), strip);
}

/// u = value + slope · (n − at) by least squares over the sites with low < n < high.
struct Line {
    double value, slope;
};

Line fit(const VectorField<>& u, const Strip& strip, double low, double high, double at) {
    const Lattice& lattice = u.x.lattice();
    double s0 = 0, s1 = 0, s2 = 0, y0 = 0, y1 = 0;
    for (int j = 0; j < lattice.ny; ++j) {
        for (int i = 0; i < lattice.nx; ++i) {
            const double n = strip.depth(Lattice::position(i, j));
            if (n < low || n > high) continue;
            const double x = n - at, y = u.x(i, j) * strip.tx + u.y(i, j) * strip.ty;
            s0 += 1, s1 += x, s2 += x * x, y0 += y, y1 += x * y;
        }
    }
    const double slope = (s0 * y1 - s1 * y0) / (s0 * s2 - s1 * s1);
    return {(y0 - slope * s1) / s0, slope};
}

/// At the first membrane, all in units of velocity but for the stress.
struct Seen {
    double slip;         ///< of the plasma past the cytoplasm
    double node;         ///< node velocity less the mean of both
    double rate;         ///< interpolated t·(∇u + ∇uᵀ)·n, n outwards
    double mean_stress;  ///< mean of ∂ₙu ν of both sides, n inwards
};

Seen see(const Delta& delta, const Strip& strip, int box, double ratio, double load,
         double dipole) {
    const Lattice lattice{box, box, false};
    Relaxation relaxation(lattice);
    for (int j = 0; j < box; ++j) {
        for (int i = 0; i < box; ++i) {
            const double nu =
                HarmonicMean{}(plasma, ratio * plasma, fraction(Lattice::position(i, j), strip));
            const Rates rates = Trt{}.rates(nu);
            relaxation.even(i, j) = rates.even;
            relaxation.odd(i, j) = rates.odd;
        }
    }
    const double length = box * box / strip.period;
    const int count = static_cast<int>(length / 0.8);
    const double arc = length / count;
    Suspension cells;
    cells.first = {0, 2 * count};
    for (const double n : {strip.from, strip.from + strip.width}) {
        const double side = n == strip.from ? 1.0 : -1.0;
        for (int k = 0; k < count; ++k) {
            const double s = (k + 0.3) * arc;
            cells.x.push_back(strip.tx * s - strip.ty * n);
            cells.y.push_back(strip.ty * s + strip.tx * n);
            cells.fx.push_back(side * load * strip.tx * arc);
            cells.fy.push_back(side * load * strip.ty * arc);
            // Counter-clockwise t and outward n both change sign from one membrane to the other.
            cells.dipole_xx.push_back(2.0 * dipole * strip.tx * strip.ty * arc);
            cells.dipole_xy.push_back(dipole * (strip.ty * strip.ty - strip.tx * strip.tx) * arc);
        }
    }
    for (auto* v : {&cells.ux, &cells.uy, &cells.rate_xx, &cells.rate_xy}) v->resize(2 * count);
    Stencils stencils(2 * count);
    VectorField force(lattice), u(lattice);
    Populations populations(lattice);
    Periodic exchange;
    locate(delta, lattice, cells, stencils);
    spread(Order::first, stencils, cells, force);
    exchange.fold(force);
    for (int step = 0; step < 5 * box * box / 4; ++step) {
        collide_and_stream(LinearEquilibrium{}, {}, {}, force, relaxation, populations, u);
        settle(exchange, populations);
    }
    exchange.fill(u);
    for (int c = 0; c < cells.cell_count(); ++c) interpolate(Order::first, stencils, u, cells, c);

    const double beyond = 3.0;
    const Line inside = fit(u, strip, beyond, strip.width - beyond, 0.0);
    const Line outside = fit(u, strip, strip.width + beyond, strip.period - beyond, strip.period);
    double velocity = 0.0, rate = 0.0;
    for (int k = 0; k < count; ++k) {
        velocity += (cells.ux[k] * strip.tx + cells.uy[k] * strip.ty) / count;
        rate += (2.0 * strip.tx * strip.ty * cells.rate_xx[k] +
                 (strip.ty * strip.ty - strip.tx * strip.tx) * cells.rate_xy[k]) /
                count;
    }
    return {outside.value - inside.value, velocity - 0.5 * (inside.value + outside.value), rate,
            0.5 * plasma * (ratio * inside.slope + outside.slope)};
}

/// Responses to load and to dipole, in units of their velocities, averaged over positions on the
/// lattice. What the mean stress does is taken off by its own law, −c_φ Δφ σ̄ and −φ̄ σ̄.
struct Response {
    double slip_of_load = 0, node_of_load = 0, rate_of_load = 0;
    double slip_of_dipole = 0, node_of_dipole = 0, rate_of_dipole = 0;
};

Response measure(const Delta& delta, int p, int q, double ratio, double slip_length) {
    const int box = q == 0 ? 40 : 56, positions = 4;
    const double mean_fluidity = 0.5 * (1.0 + 1.0 / ratio), fluidity_jump = 1.0 - 1.0 / ratio;
    const double unit = 1e-3;
    Response r;
    for (int k = 0; k < positions; ++k) {
        const Strip strip(p, q, box, 0.5, 0.137 + k / (positions * std::hypot(p, q)));
        for (const bool by_load : {true, false}) {
            const Seen seen =
                see(delta, strip, box, ratio, by_load ? unit : 0.0, by_load ? 0.0 : unit);
            const double scale = plasma / (unit * positions);
            const double stress = seen.mean_stress / plasma;
            (by_load ? r.slip_of_load : r.slip_of_dipole) += scale * seen.slip;
            (by_load ? r.node_of_load : r.node_of_dipole) +=
                scale * (seen.node + slip_length * fluidity_jump * stress);
            (by_load ? r.rate_of_load : r.rate_of_dipole) +=
                scale * (seen.rate + mean_fluidity * stress);
        }
    }
    return r;
}

TEST(StraightMembrane, is_smeared_by_kernel_and_lattice_as_the_kernel_states) {
    for (const Delta& delta : {Delta{Peskin4{}}, Delta{Cosine4{}}, Delta{Roma3{}}}) {
        const KernelSpread s = std::visit([](const auto& k) { return k.spread; }, delta);
        for (const double ratio : {1.0, 5.0}) {
            for (const int q : {0, 1}) {
                const double t = q == 0 ? 1.0 : std::sqrt(0.5);
                const double length = s.slip(t, q * t);
                const double mean = 0.5 * (1.0 + 1.0 / ratio), jump = 1.0 - 1.0 / ratio;
                const Response r = measure(delta, 1, q, ratio, length);
                EXPECT_NEAR(r.slip_of_load, jump * length, 0.004);
                EXPECT_NEAR(r.node_of_load, -mean * s.force, 0.006);
                EXPECT_NEAR(r.rate_of_load, -jump * s.share, 0.008);
                EXPECT_NEAR(r.slip_of_dipole, mean, 0.003);
                EXPECT_NEAR(r.node_of_dipole, -jump * s.share, 0.008);
                EXPECT_NEAR(r.rate_of_dipole, mean * s.square, 0.01);
            }
        }
    }
}

}  // namespace
}  // namespace tt
