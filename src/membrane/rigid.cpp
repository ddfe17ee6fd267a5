#include "membrane/rigid.hpp"

#include <cmath>

#include "base/vec2.hpp"
#include "membrane/outline.hpp"

namespace tt {
namespace {

/// A node and what of the outline is its own.
struct Node {
    Vec2 at;
    double arc;   ///< half of the two segments beside it
    Vec2 normal;  ///< outward, times the length that it stands for: ∂A/∂x
};

/// Calls f(n, node) for each node of the cell.
template <class F>
void for_each_node(const Suspension& cells, int cell, F&& f) {
    const int begin = cells.first[cell], end = cells.first[cell + 1];
    Vec2 before = cells.position(end - 1), here = cells.position(begin);
    double length_before = norm(here - before);
    for (int n = begin; n < end; ++n) {
        const Vec2 next = cells.position(n + 1 < end ? n + 1 : begin);
        const double length = norm(next - here);
        f(n, Node{here, 0.5 * (length_before + length), 0.5 * turned_right(next - before)});
        before = here, here = next, length_before = length;
    }
}

/// Velocity at `centre`, about which it turns.
struct RigidMotion {
    Vec2 centre, velocity;
    double spin = 0.0;

    Vec2 at(Vec2 place) const {
        const Vec2 arm = place - centre;
        return {velocity.x - spin * arm.y, velocity.y + spin * arm.x};
    }
};

/// The one nearest to the velocities of the nodes, ∫ |u − U − Ω × r|² ds least.
RigidMotion nearest_motion(const Suspension& cells, int cell) {
    const Vec2 origin = cells.position(cells.first[cell]);
    double length = 0.0;
    Vec2 first_moment, flow;
    for_each_node(cells, cell, [&](int n, const Node& node) {
        length += node.arc;
        first_moment += node.arc * (node.at - origin);
        flow += node.arc * cells.velocity(n);
    });
    RigidMotion motion{origin + first_moment / length, flow / length};
    double turning = 0.0, inertia = 0.0;
    for_each_node(cells, cell, [&](int n, const Node& node) {
        const Vec2 arm = node.at - motion.centre;
        turning += node.arc * cross(arm, cells.velocity(n) - motion.velocity);
        inertia += node.arc * dot(arm, arm);
    });
    motion.spin = turning / inertia;
    return motion;
}

/// dλ ds.
void hold(double mobility, const RigidMotion& motion, Suspension& cells, int cell) {
    // Of the slip, what would change the enclosed area is no business of λ.
    double swelling = 0.0, unit = 0.0;
    for_each_node(cells, cell, [&](int n, const Node& node) {
        swelling += dot(motion.at(node.at) - cells.velocity(n), node.normal);
        unit += dot(node.normal, node.normal) / node.arc;
    });
    const double share = swelling / unit, by = 1.0 / mobility;
    for_each_node(cells, cell, [&](int n, const Node& node) {
        const Vec2 slip = node.arc * (motion.at(node.at) - cells.velocity(n)) - share * node.normal;
        cells.rigid_fx[n] += by * slip.x;
        cells.rigid_fy[n] += by * slip.y;
    });
}

}  // namespace

void set_rigid_forces(Suspension& cells, int cell) {
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        cells.fx[n] = cells.rigid_fx[n];
        cells.fy[n] = cells.rigid_fy[n];
    }
}

void move_rigidly(double mobility, Suspension& cells, int cell) {
    const RigidMotion motion = nearest_motion(cells, cell);
    hold(mobility, motion, cells, cell);
    const double cosine = std::cos(motion.spin), sine = std::sin(motion.spin);
    const auto turned = [&](Vec2 v) {
        return Vec2{cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
    };
    for (int n = cells.first[cell]; n < cells.first[cell + 1]; ++n) {
        const Vec2 place = cells.position(n), velocity = motion.at(place);
        const Vec2 to = motion.centre + motion.velocity + turned(place - motion.centre);
        const Vec2 load = turned({cells.rigid_fx[n], cells.rigid_fy[n]});
        cells.ux[n] = velocity.x, cells.uy[n] = velocity.y;
        cells.x[n] = to.x, cells.y[n] = to.y;
        cells.rigid_fx[n] = load.x, cells.rigid_fy[n] = load.y;
    }
}

}  // namespace tt
