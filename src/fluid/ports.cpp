#include "fluid/ports.hpp"

#include <utility>

namespace tt {

template <class Real>
Ports<Real>::Ports(const Walls& walls, const Populations<Real>& populations) {
    const Lattice& lattice = walls.lattice;
    const auto place = [&](int slot, int i, int j) {
        return static_cast<std::uint32_t>(populations.row(slot, lattice.row_in_box(j)) +
                                          wrapped(i, lattice.nx));
    };
    ports_.resize(walls.openings.size());
    for (const OpeningLink& link : walls.inflow) {
        Port& port = ports_[link.opening];
        port.across_x = walls.openings[link.opening].out_x != 0;
        const int k = link.direction, m = port.across_x ? d2q9::mirrored_x[k] : d2q9::mirrored_y[k];
        const int dx = d2q9::cx[k], dy = d2q9::cy[k];
        const int tx = port.across_x ? 0 : dx, ty = port.across_x ? dy : 0;
        const auto weight = static_cast<Real>(d2q9::weight[k]);
        port.links.push_back({place(d2q9::opposite[m], link.i - tx, link.j - ty),
                              place(d2q9::opposite[k], link.i - dx, link.j - dy),
                              place(m, link.i - dx + tx, link.j - dy + ty),
                              place(k, link.i, link.j), link.i, link.j, k, weight});
        port.weight += d2q9::weight[k];
    }
}

template <class Real>
void Ports<Real>::apply(const std::vector<PortCondition>& conditions,
                        const VectorField<Real>* velocity, const FeedPopulations<Real>& feeds,
                        Populations<Real>& populations, std::vector<PortFlow>& flow) const {
    Real* const f = populations.data();
    const bool even = populations.phase == Phase::even;
    const auto dynamic = [&](const Port& port, const Link& link) {
        if (!velocity) return 0.0;
        const double u = port.across_x ? velocity->x(link.i, link.j) : velocity->y(link.i, link.j);
        return 6.0 * link.weight * u * u;
    };
    for (std::size_t n = 0; n < ports_.size(); ++n) {
        const Port& port = ports_[n];
        if (const auto* from = std::get_if<FedInflow>(&conditions[n])) {
            feed(port, *from, feeds(from->feed), populations, flow[n]);
            continue;
        }
        double gone = 0.0, extra = 0.0;
        for (const Link& link : port.links) {
            gone += f[even ? link.even_source : link.odd_source];
            extra += dynamic(port, link);
        }
        double density = 0.0;
        if (const auto* held = std::get_if<HeldDensity>(&conditions[n]))
            density = flow[n].factor * held->deviation;
        else
            density =
                (flow[n].factor * std::get<HeldInflow>(conditions[n]).rate + 2.0 * gone - extra) /
                (2.0 * port.weight);
        flow[n].density = {density, flow[n].density[0]};
        flow[n].inflow = {2.0 * port.weight * density + extra - 2.0 * gone, flow[n].inflow[0]};
        for (const Link& link : port.links) {
            const double source = f[even ? link.even_source : link.odd_source];
            f[even ? link.even_target : link.odd_target] =
                static_cast<Real>(2.0 * link.weight * density + dynamic(port, link) - source);
        }
    }
}

template <class Real>
void Ports<Real>::feed(const Port& port, const FedInflow& from, const Populations<Real>& there,
                       Populations<Real>& here, PortFlow& flow) {
    Real* const f = here.data();
    const bool even = here.phase == Phase::even;
    const Lattice& channel = there.lattice();
    const auto arriving = [&](int k, int i, int j) {
        return there.arriving(k, wrapped(i - from.i, channel.nx), wrapped(j - from.j, channel.ny));
    };
    double here_gone = 0.0, there_gone = 0.0, arrived = 0.0;
    for (const Link& link : port.links) {
        const int k = link.direction;
        // What departs lies where the other phase looks for what arrives.
        here_gone += f[even ? link.odd_target : link.even_target];
        there_gone += arriving(d2q9::opposite[k], link.i - d2q9::cx[k], link.j - d2q9::cy[k]);
        arrived += arriving(k, link.i, link.j);
    }
    const double more = (here_gone - there_gone) / port.weight;
    for (const Link& link : port.links)
        f[even ? link.even_target : link.odd_target] =
            static_cast<Real>(arriving(link.direction, link.i, link.j) + link.weight * more);
    const double in = arrived + port.weight * more;
    flow.density = {0.5 * (in + here_gone) / port.weight, flow.density[0]};
    flow.inflow = {in - here_gone, flow.inflow[0]};
}

template class Ports<double>;
template class Ports<float>;

}  // namespace tt
