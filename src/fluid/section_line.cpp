#include "fluid/section_line.hpp"

#include <algorithm>
#include <cmath>

namespace tt {
namespace {

struct SitePair {
    int before_i, before_j, behind_i, behind_j;
};

/// The sites on both sides of the line, `along` it, the one behind shifted by `aside`.
SitePair sites_at(const SectionLine& line, const Lattice& lattice, int along, int aside) {
    const auto column = [&](int i) { return wrapped(i, lattice.nx); };
    if (line.upright)
        return {column(line.plane - 1), lattice.row_in_box(along), column(line.plane),
                lattice.row_in_box(along + aside)};
    return {column(along), lattice.row_in_box(line.plane - 1), column(along + aside),
            lattice.row_in_box(line.plane)};
}

}  // namespace

SectionLine section_line(const Lattice& lattice, const Walls* walls, bool upright, int plane,
                         double begin, double end) {
    SectionLine line;
    line.upright = upright;
    line.plane = plane;
    line.begin = begin;
    line.end = end;
    const auto is_open = [&](int i, int j) {
        return j >= 0 && j < lattice.ny && (!walls || walls->is_open(i, j));
    };
    // A slanting wall may leave a site open beside the end of the line; another channel begins
    // behind closed ones.
    constexpr int beside = 2;
    const auto any_open = [&](int along) {
        const SitePair at = sites_at(line, lattice, along, 0);
        return is_open(at.before_i, at.before_j) || is_open(at.behind_i, at.behind_j);
    };
    const int middle = static_cast<int>(std::floor(0.5 * (begin + end)));
    int first = middle, last = middle;
    while (first > begin - beside && any_open(first - 1)) --first;
    while (last < end + beside && any_open(last)) ++last;
    for (int along = first; along < last; ++along)
        for (const int aside : {-1, 0, 1}) {
            const SitePair at = sites_at(line, lattice, along, aside);
            if (!is_open(at.before_i, at.before_j) || !is_open(at.behind_i, at.behind_j)) continue;
            for (int k = 1; k < d2q9::count; ++k) {
                const int cn = upright ? d2q9::cx[k] : d2q9::cy[k];
                const int ct = upright ? d2q9::cy[k] : d2q9::cx[k];
                if (cn == 1 && ct == aside) line.links.push_back({at.behind_i, at.behind_j, k});
            }
            if (aside == 0) line.rows.push_back(along);
        }
    return line;
}

template <class Real>
SectionReading read_section(const SectionLine& line, const Populations<Real>& populations) {
    const Lattice& lattice = populations.lattice();
    SectionReading reading;
    for (const SectionLine::Link& link : line.links) {
        const int k = link.direction;
        const int i = wrapped(link.i - d2q9::cx[k], lattice.nx);
        const int j = lattice.row_in_box(link.j - d2q9::cy[k]);
        reading.inflow +=
            populations.arriving(k, link.i, link.j) - populations.arriving(d2q9::opposite[k], i, j);
    }
    reading.inflow *= line.sign;
    for (const int along : line.rows) {
        const SitePair at = sites_at(line, lattice, along, 0);
        for (int k = 0; k < d2q9::count; ++k)
            reading.density += populations.arriving(k, at.before_i, at.before_j) +
                               populations.arriving(k, at.behind_i, at.behind_j);
    }
    if (!line.rows.empty()) reading.density /= 2.0 * static_cast<double>(line.rows.size());
    return reading;
}

template <class Real>
void read_velocity(const SectionLine& line, const VectorField<Real>& velocity,
                   std::vector<double>& result) {
    const Field<Real>& through = line.upright ? velocity.x : velocity.y;
    result.clear();
    for (const int along : line.rows) {
        const SitePair at = sites_at(line, through.lattice(), along, 0);
        result.push_back(0.5 * line.sign *
                         (static_cast<double>(through(at.before_i, at.before_j)) +
                          static_cast<double>(through(at.behind_i, at.behind_j))));
    }
}

template SectionReading read_section(const SectionLine&, const Populations<double>&);
template SectionReading read_section(const SectionLine&, const Populations<float>&);
template void read_velocity(const SectionLine&, const VectorField<double>&, std::vector<double>&);
template void read_velocity(const SectionLine&, const VectorField<float>&, std::vector<double>&);

}  // namespace tt
