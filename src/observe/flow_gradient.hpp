#pragma once

#include "base/vec2.hpp"
#include "fluid/boundaries.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"

namespace tt {

/// ∂u/∂x and ∂u/∂y at one place, per step.
struct VelocityGradient {
    Vec2 by_x;
    Vec2 by_y;
};

/// A read-only look at the velocity field that knows what lies beyond its edges: the periodic image
/// or the wall. Reads sites only, never the halo. Lattice units.
template <class Real>
class FlowView {
public:
    FlowView(const VectorField<Real>& velocity, const Boundaries& boundaries)
        : velocity_(velocity), boundaries_(boundaries), lattice_(velocity.x.lattice()) {}

    /// Column and row brought back into the box; y only where it is periodic.
    int column(int i) const { return wrapped(i, lattice_.nx); }
    int row(int j) const { return lattice_.row_in_box(j); }

    /// At a site: central differences; in the rows next to a wall ∂u/∂y by the parabola through the
    /// wall and two sites. Second order, exact for a quadratic field.
    VelocityGradient at_site(int i, int j) const {
        const bool inside = i > 0 && i + 1 < lattice_.nx && j > 0 && j + 1 < lattice_.ny;
        return inside ? central(i, j) : at_edge(i, j);
    }

    /// Bilinear between the four sites around `position`, from the 12 sites of `at_site` there.
    /// Exact for a quadratic field. Precondition: with walls, ½ ≤ y ≤ ny − ½.
    VelocityGradient at(Vec2 position) const;

    /// ∂u_x/∂y on the wall above or below column i, by the parabola through the wall and two sites.
    double at_bottom_wall(int i) const;
    double at_top_wall(int i) const;

private:
    VelocityGradient central(int i, int j) const {
        return {0.5 * (velocity_(i + 1, j) - velocity_(i - 1, j)),
                0.5 * (velocity_(i, j + 1) - velocity_(i, j - 1))};
    }
    VelocityGradient at_edge(int i, int j) const;

    const VectorField<Real>& velocity_;
    const Boundaries& boundaries_;
    const Lattice& lattice_;
};

/// Largest shear rate at a place, in whatever direction: the difference of the principal rates of
/// strain, √((e_xx − e_yy)² + 4 e_xy²); with ∇·u = 0 it is 2 √(e_xx² + e_xy²). It is k in u = k y.
double principal_shear_rate(const VelocityGradient& gradient);

/// Kinematic viscosity that a site's relaxation rate stands for, ν = (τ⁺ − ½)/3. Lattice units.
template <class Real>
double local_viscosity(const Relaxation<Real>& relaxation, int i, int j) {
    return (1.0 / relaxation.even(i, j) - 0.5) / 3.0;
}

}  // namespace tt
