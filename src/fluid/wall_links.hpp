#pragma once

#include <cstdint>
#include <vector>

#include "fluid/populations.hpp"
#include "fluid/walls.hpp"

namespace tt {

/// κ of central linear interpolation for a wall at the share q of a link, and the factor of what a
/// moving wall adds. With one open site only the wall is taken as half-way.
constexpr double link_kappa(const WallLink& link) {
    return link.second ? (1.0 - 2.0 * link.q) / (1.0 + 2.0 * link.q) : 0.0;
}
constexpr double link_gain(const WallLink& link) {
    const double q = link.second ? link.q : 0.5;
    const int i = link.direction;
    return 12.0 / (1.0 + 2.0 * q) * d2q9::weight[i] *
           (d2q9::cx[i] * link.velocity.x + d2q9::cy[i] * link.velocity.y);
}

/// What walls of any shape do to the populations that a pass has just left: central linear
/// interpolation (CLI; Ginzburg, Verhaeghe and d'Humières 2008). Of site x with the wall at the
/// share q of the way to x − c_i, ī the opposite of i and g what departs,
///
///     f_i(x) = g_ī(x) + κ (g_ī(x + c_i) − g_i(x)) + 12/(1 + 2q) w_i c_i·u_w,   κ = (1 − 2q)/(1 +
///     2q):
///
/// second order, the same at any relaxation time with two of them, half-way bounce-back for q = ½.
/// Interpolation alone would let mass through a wall; what all links of a loop together gain is
/// taken off them in proportion to w_i, so that each loop keeps mass to rounding.
///
/// In place a link is four slots (docs/theory/walls.md): A = slot i of x, B = slot ī of x, C = slot
/// i of x + c_i, D = slot ī of x − c_i, which no open site owns. After an even pass D ← A + κ(C −
/// B), after an odd one A ← D + κ(B − C). No target is a source: any order, any threads.
template <class Real = double>
class WallLinks {
public:
    WallLinks() = default;
    WallLinks(const Walls& walls, const Populations<Real>& populations);

    bool empty() const { return links_.empty(); }

    /// After a pass in the phase that the populations still have; what it left lies in the box, not
    /// in the halo. Team function; waits for all, and is done when all threads have returned.
    void apply(Populations<Real>& populations);

private:
    struct Link {
        std::uint32_t a, b, c, d;
        Real kappa, gain, weight;
    };
    /// Links of one loop, a few of them: what a thread takes, and a sum in a fixed order.
    struct Block {
        int begin, end, loop;
    };

    std::vector<Link> links_;
    std::vector<Block> blocks_;
    std::vector<double> weights_;  ///< Σ w of each loop
    std::vector<Real> gains_;      ///< of each link, in this step
    std::vector<double> sums_;     ///< of each block
};

}  // namespace tt
