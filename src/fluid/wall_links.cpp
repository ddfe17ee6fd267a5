#include "fluid/wall_links.hpp"

#include <algorithm>

#include "base/contracts.hpp"
#include "base/parallel.hpp"

namespace tt {
namespace {

constexpr int block_size = 64;

}  // namespace

template <class Real>
WallLinks<Real>::WallLinks(const Walls& walls, const Populations<Real>& populations) {
    const Lattice& lattice = walls.lattice;
    const auto place = [&](int slot, int i, int j) {
        return static_cast<std::uint32_t>(populations.row(slot, lattice.row_in_box(j)) +
                                          wrapped(i, lattice.nx));
    };
    for (const WallLink& link : walls.links) {
        const int k = link.direction, back = d2q9::opposite[k];
        const int dx = d2q9::cx[k], dy = d2q9::cy[k];
        Link to{};
        to.a = place(k, link.i, link.j);
        to.b = place(back, link.i, link.j);
        to.c = link.second ? place(k, link.i + dx, link.j + dy) : to.b;
        // At a wall of the lattice a site keeps in its own slot what departs and what comes back.
        to.d = link.row_wall ? to.a : place(back, link.i - dx, link.j - dy);
        to.kappa = static_cast<Real>(link_kappa(link));
        to.gain = static_cast<Real>(link_gain(link));
        to.weight = static_cast<Real>(d2q9::weight[k]);
        const auto n = static_cast<int>(links_.size());
        if (blocks_.empty() || blocks_.back().loop != link.loop ||
            n - blocks_.back().begin == block_size)
            blocks_.push_back({n, n, link.loop});
        blocks_.back().end = n + 1;
        weights_.resize(std::max(weights_.size(), static_cast<std::size_t>(link.loop) + 1), 0.0);
        weights_[link.loop] += d2q9::weight[k];
        links_.push_back(to);
    }
    gains_.resize(links_.size());
    sums_.resize(blocks_.size());
}

template <class Real>
void WallLinks<Real>::apply(Populations<Real>& populations) {
    if (empty()) return;
    team_barrier();  // all is left where it belongs
    Real* const f = populations.data();
    const bool even = populations.phase == Phase::even;
    const auto [begin, end] = team_share(static_cast<int>(blocks_.size()));
    for (int n = begin; n < end; ++n) {
        double sum = 0.0;
        for (int l = blocks_[n].begin; l < blocks_[n].end; ++l) {
            const Link& link = links_[l];
            const Real apart = even ? f[link.c] - f[link.b] : f[link.b] - f[link.c];
            gains_[l] = link.kappa * apart + link.gain;
            sum += gains_[l];
        }
        sums_[n] = sum;
    }
    team_barrier();
    int loop = -1;
    Real excess = 0;  // of this loop, per weight
    for (int n = begin; n < end; ++n) {
        if (blocks_[n].loop != loop) {
            loop = blocks_[n].loop;
            double sum = 0.0;
            const auto of_loop = [&](const Block& block) { return block.loop == loop; };
            auto first = std::find_if(blocks_.begin(), blocks_.end(), of_loop);
            for (; first != blocks_.end() && first->loop == loop; ++first)
                sum += sums_[first - blocks_.begin()];
            excess = static_cast<Real>(sum / weights_[loop]);
        }
        for (int l = blocks_[n].begin; l < blocks_[n].end; ++l) {
            const Link& link = links_[l];
            const Real gain = gains_[l] - link.weight * excess;
            if (even)
                f[link.d] = f[link.a] + gain;
            else
                f[link.a] = f[link.d] + gain;
        }
    }
}

template class WallLinks<double>;
template class WallLinks<float>;

}  // namespace tt
