#include "simulation/undisturbed.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "exchange/periodic.hpp"
#include "fluid/collide_stream.hpp"
#include "fluid/collision/collision.hpp"
#include "fluid/borders.hpp"

namespace tt {
namespace {

constexpr double force = 1e-6;
constexpr double usual_viscosity = 0.5;  // τ = 2: momentum spreads fast, pressure not too slowly

/// Fluid and walls, at rest at first.
struct Settling {
    Boundaries boundaries;
    VectorField<> no_force, velocity;
    Relaxation<> relaxation;
    Populations<> populations;
    Borders<> borders;
    std::vector<PortFlow> ports;
    Periodic exchange;
    Vec2 push;  ///< the force

    Settling(const Walls& walls, Vec2 direction, double viscosity = usual_viscosity)
        : no_force(walls.lattice),
          velocity(walls.lattice),
          relaxation(walls.lattice),
          populations(walls.lattice),
          borders(walls, populations),
          push(force * direction) {
        boundaries.walls = std::shared_ptr<const Walls>(std::shared_ptr<void>(), &walls);
        const Rates rates = Trt{}.rates(viscosity);
        relaxation.even.fill(rates.even);
        relaxation.odd.fill(rates.odd);
    }
    /// What enters through ports and does not leave, over what passes them.
    double imbalance() const {
        double sum = 0.0, passing = 0.0;
        for (const PortFlow& port : ports) {
            sum += port.mean_inflow();
            passing += std::fabs(port.mean_inflow());
        }
        return passing > 0.0 ? std::fabs(sum) / passing : 0.0;
    }
    void step() {
        collide_and_stream(LinearEquilibrium{}, boundaries, push, no_force, relaxation, populations,
                           velocity);
        settle(exchange, populations, [&] {
            return borders.apply(LinearEquilibrium{}, boundaries, velocity, {}, populations, ports);
        });
        team_barrier();
    }
};

Vec2 mean_velocity(const VectorField<>& velocity) {
    const Lattice& lattice = velocity.x.lattice();
    return Vec2{sum_over_sites(velocity.x), sum_over_sites(velocity.y)} /
           (static_cast<double>(lattice.nx) * lattice.ny);
}

/// What is looked at, and the size of which a share must be left at most.
struct Reading {
    double value, size;
};

/// Until what is left to come of all that `read` looks at, by the pace at which changes get
/// smaller, is a share of 10⁻⁵, and as much goes out as comes in.
template <class Read>
void run_until_steady(Settling& flow, int threads, Read&& read) {
    constexpr int steps = 250, most = 4000;
    constexpr double share = 1e-5;
    std::vector<double> values, changes;
    for (int n = 0; n < most; ++n) {
        with_team(threads, [&] {
            for (int k = 0; k < steps; ++k) flow.step();
        });
        const std::vector<Reading> readings = read();
        values.resize(readings.size(), 0.0);
        changes.resize(readings.size(), HUGE_VAL);
        bool steady = true;
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const double now = readings[k].value;
            const double before = std::exchange(changes[k], now - values[k]);
            values[k] = now;
            const double pace = std::fabs(changes[k] / before);
            const double left = pace < 1.0 ? std::fabs(changes[k]) * pace / (1.0 - pace) : HUGE_VAL;
            // Changes of rounding have no pace.
            const bool rounding = std::fabs(changes[k]) < 1e-9 * readings[k].size;
            steady = steady && (left < share * readings[k].size || rounding || changes[k] == 0.0);
        }
        if (n > 2 && steady && flow.imbalance() < share) return;
    }
}

void measure(const Walls& walls, UndisturbedFlow& flow) {
    const VectorField<>& u = flow.velocity;
    for (int j = 0; j < walls.lattice.ny; ++j)
        for (int i = 0; i < walls.lattice.nx; ++i)
            flow.fastest = std::max(flow.fastest, norm(u(i, j)));
    const auto rate = [&](int i, int j, bool upright, double q) {
        const double along = upright ? u.x(i, j) : u.y(i, j);
        flow.steepest = std::max(flow.steepest, std::fabs(along) / std::max(q, 0.3));
    };
    for (const WallLink& link : walls.links) {
        const int k = link.direction;
        if (k < 5) rate(link.i, link.j, d2q9::cx[k] == 0, link.q);
    }
    if (!walls.lattice.walls) return;
    for (int i = 0; i < walls.lattice.nx; ++i)
        for (const int j : {0, walls.lattice.ny - 1}) rate(i, j, true, 0.5);
}

/// Adds the mean of the next two steps.
void average_two_steps(const Walls& walls, Settling& settling, std::span<const SectionLine> lines,
                       UndisturbedFlow& flow) {
    const Lattice& lattice = walls.lattice;
    VectorField<>& velocity = flow.velocity;
    Field<>& density = flow.density;
    for (int step = 0; step < 2; ++step) {
        settling.step();
        for (int j = 0; j < lattice.ny; ++j) {
            const std::vector<double> now = density_deviations(settling.populations, j);
            for (int i = 0; i < lattice.nx; ++i) {
                if (!walls.is_open(i, j)) continue;
                velocity.x(i, j) += 0.5 * settling.velocity.x(i, j);
                velocity.y(i, j) += 0.5 * settling.velocity.y(i, j);
                density(i, j) += 0.5 * now[i];
            }
        }
        for (std::size_t n = 0; n < lines.size(); ++n) {
            const SectionReading now = read_section(lines[n], settling.populations);
            flow.sections[n].inflow += 0.5 * now.inflow;
            flow.sections[n].density += 0.5 * now.density;
        }
    }
}

UndisturbedFlow at_rest(const Walls& walls, std::size_t sections) {
    UndisturbedFlow flow;
    flow.velocity = VectorField<>(walls.lattice);
    flow.density = Field<>(walls.lattice);
    flow.sections.resize(sections);
    return flow;
}

/// Velocity and density where a force along this direction has made them steady, each the mean of
/// two steps; on sections with what the force stands for.
UndisturbedFlow settled_along(const Walls& walls, Vec2 direction, int threads,
                              std::span<const SectionLine> lines) {
    Settling settling(walls, direction);
    run_until_steady(settling, threads, [&] {
        const double along = dot(mean_velocity(settling.velocity), settling.push) / force;
        return std::vector<Reading>{{along, std::fabs(along)}};
    });
    UndisturbedFlow flow = at_rest(walls, lines.size());
    average_two_steps(walls, settling, lines, flow);
    for (std::size_t n = 0; n < lines.size(); ++n)
        flow.sections[n].density -=
            dot(settling.push, lines[n].middle()) / d2q9::sound_speed_squared;
    return flow;
}

/// Takes off what turns the mean flow aside.
void keep_along_x(const Walls& walls, int threads, std::span<const SectionLine> lines,
                  UndisturbedFlow& flow) {
    const UndisturbedFlow aside = settled_along(walls, {0.0, 1.0}, threads, lines);
    flow.lean = -mean_velocity(flow.velocity).y / mean_velocity(aside.velocity).y;
    for (std::size_t n = 0; n < flow.density.size(); ++n) {
        flow.velocity.x.data()[n] += flow.lean * aside.velocity.x.data()[n];
        flow.velocity.y.data()[n] += flow.lean * aside.velocity.y.data()[n];
        flow.density.data()[n] += flow.lean * aside.density.data()[n];
    }
    for (std::size_t n = 0; n < lines.size(); ++n) {
        flow.sections[n].inflow += flow.lean * aside.sections[n].inflow;
        flow.sections[n].density += flow.lean * aside.sections[n].density;
    }
}

}  // namespace

template <class Real>
double flow_beside_walls(const Walls& walls, const Field<Real>& u) {
    double sum = 0.0;
    for (const WallLink& link : walls.links) {
        if (d2q9::cx[link.direction] != 0) continue;
        const double q = std::max(link.q, 1e-3), off = q - 0.5;
        const double here = u(link.i, link.j);
        sum += here / q * (0.5 * off * off - 1.0 / 24.0);
        if (link.row_wall) sum += 2.0 * here / 24.0;  // and not that of the lattice's own wall
    }
    if (!walls.lattice.walls) return sum;
    for (const int j : {0, walls.lattice.ny - 1})
        for (int i = 0; i < walls.lattice.nx; ++i) sum -= 2.0 * u(i, j) / 24.0;
    return sum;
}
template double flow_beside_walls(const Walls&, const Field<double>&);
template double flow_beside_walls(const Walls&, const Field<float>&);

UndisturbedFlow undisturbed_flow(const Walls& walls, std::span<const SectionLine> sections,
                                 int threads) {
    const Lattice& lattice = walls.lattice;
    UndisturbedFlow flow = settled_along(walls, {1.0, 0.0}, threads, sections);
    // A lean of rounding is none.
    const Vec2 mean = mean_velocity(flow.velocity);
    if (!lattice.walls && std::fabs(mean.y) > 1e-5 * std::fabs(mean.x))
        keep_along_x(walls, threads, sections, flow);
    const double viscosity = usual_viscosity;
    const double rate =
        (sum_over_sites(flow.velocity.x) + flow_beside_walls(walls, flow.velocity.x)) / lattice.nx;
    flow.conductance = rate * viscosity / force;
    const double unit = rate / lattice.ny;
    for (std::size_t n = 0; n < flow.density.size(); ++n) {
        flow.velocity.x.data()[n] /= unit;
        flow.velocity.y.data()[n] /= unit;
        flow.density.data()[n] /= unit * viscosity;
    }
    for (SectionReading& section : flow.sections) {
        section.inflow /= unit;
        section.density /= unit * viscosity;
    }
    flow.site_mean = mean_velocity(flow.velocity).x;
    measure(walls, flow);
    return flow;
}

UndisturbedFlow undisturbed_flow(const Walls& walls, const std::vector<PortCondition>& conditions,
                                 std::span<const SectionLine> sections, int threads) {
    // Momentum spreads across in H²/(π² ν) steps and density along in some 18 ν (A/H²)² (of a
    // channel of area A): the viscosity for which both are alike.
    double widest = 0.0;
    for (const LatticeOpening& opening : walls.openings)
        widest = std::max(widest, static_cast<double>(opening.width));
    const double viscosity = std::clamp(
        std::pow(widest, 3) / (13.3 * static_cast<double>(walls.open_sites())), 0.05, 0.5);
    Settling settling(walls, {}, viscosity);
    settling.boundaries.ports = conditions;
    for (PortCondition& condition : settling.boundaries.ports)
        if (auto* held = std::get_if<HeldDensity>(&condition)) held->deviation *= viscosity;
    settling.ports.resize(conditions.size());
    run_until_steady(settling, threads, [&] {
        double fastest = 0.0, highest = 0.0;
        for (const PortFlow& port : settling.ports) {
            fastest = std::max(fastest, std::fabs(port.mean_inflow()));
            highest = std::max(highest, std::fabs(port.mean_density()));
        }
        std::vector<Reading> readings;
        for (const PortFlow& port : settling.ports) {
            readings.push_back({port.mean_inflow(), fastest});
            readings.push_back({port.mean_density(), highest});
        }
        return readings;
    });
    UndisturbedFlow flow = at_rest(walls, sections.size());
    average_two_steps(walls, settling, sections, flow);
    for (std::size_t n = 0; n < flow.density.size(); ++n) flow.density.data()[n] /= viscosity;
    for (SectionReading& section : flow.sections) section.density /= viscosity;
    for (const PortFlow& port : settling.ports)
        flow.ports.push_back({port.mean_inflow(), port.mean_density() / viscosity});
    measure(walls, flow);
    return flow;
}

}  // namespace tt
