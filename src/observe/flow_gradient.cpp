#include "observe/flow_gradient.hpp"

#include <cmath>

namespace tt {
namespace {

Vec2 mixed(Vec2 a, Vec2 b, double t) { return (1.0 - t) * a + t * b; }

VelocityGradient mixed(const VelocityGradient& a, const VelocityGradient& b, double t) {
    return {mixed(a.by_x, b.by_x, t), mixed(a.by_y, b.by_y, t)};
}

}  // namespace

template <class Real>
VelocityGradient FlowView<Real>::at_edge(int i, int j) const {
    const Vec2 by_x = 0.5 * (velocity_(column(i + 1), j) - velocity_(column(i - 1), j));
    // The wall stands half a site off: derivative of the parabola through −½, 0 and 1.
    if (lattice_.walls && j == 0) {
        const Vec2 wall{boundaries_.bottom_speed, 0.0};
        return {by_x, -4.0 / 3.0 * wall + velocity_(i, j) + 1.0 / 3.0 * velocity_(i, j + 1)};
    }
    if (lattice_.walls && j == lattice_.ny - 1) {
        const Vec2 wall{boundaries_.top_speed, 0.0};
        return {by_x, 4.0 / 3.0 * wall - velocity_(i, j) - 1.0 / 3.0 * velocity_(i, j - 1)};
    }
    return {by_x, 0.5 * (velocity_(i, row(j + 1)) - velocity_(i, row(j - 1)))};
}

template <class Real>
VelocityGradient FlowView<Real>::at(Vec2 position) const {
    const double left = std::floor(position.x - 0.5), below = std::floor(position.y - 0.5);
    const double s = position.x - 0.5 - left, t = position.y - 0.5 - below;
    const int i = column(static_cast<int>(left)), j = row(static_cast<int>(below));
    // On the last row itself the row above has weight 0 and need not exist.
    const int above = lattice_.walls && j == lattice_.ny - 1 ? j : row(j + 1);
    const VelocityGradient low = mixed(at_site(i, j), at_site(column(i + 1), j), s);
    const VelocityGradient high = mixed(at_site(i, above), at_site(column(i + 1), above), s);
    return mixed(low, high, t);
}

template <class Real>
double FlowView<Real>::at_bottom_wall(int i) const {
    const double wall = boundaries_.bottom_speed;
    return -8.0 / 3.0 * wall + 3.0 * velocity_.x(i, 0) - velocity_.x(i, 1) / 3.0;
}

template <class Real>
double FlowView<Real>::at_top_wall(int i) const {
    const int j = lattice_.ny - 1;
    const double wall = boundaries_.top_speed;
    return 8.0 / 3.0 * wall - 3.0 * velocity_.x(i, j) + velocity_.x(i, j - 1) / 3.0;
}

double principal_shear_rate(const VelocityGradient& gradient) {
    return norm(Vec2{gradient.by_x.x - gradient.by_y.y, gradient.by_x.y + gradient.by_y.x});
}

template class FlowView<double>;
template class FlowView<float>;

}  // namespace tt
