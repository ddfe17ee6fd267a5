#include "case/step_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "case/membrane_of.hpp"
#include "membrane/stability.hpp"

namespace tt {
namespace {

// What a run showed of each number at which D, ε, λ_C or μ_rel, whichever moves most, has moved by
// 1 % (docs/theory/time-step.md). All move in proportion.
constexpr double per_percent = 100.0;

/// S ρ k a²/μ.
double reynolds_of_one_percent(bool carried, bool inertia) {
    if (carried) return inertia ? 0.035 : 0.0055;
    return inertia ? 0.013 : 0.2;
}

/// S ρ E_s a/μ², fluid at rest.
constexpr double relaxation_of_one_percent = 0.6;

/// (τ − ½) V Δt/a, cells that are carried at V.
constexpr double delay_of_one_percent = 0.0025;

/// Drop of the density along a channel between pressure ends, equilibrium full.
constexpr double density_drop_of_one_percent = 0.0042;

/// The name of the limit where there is none.
constexpr const char* unlimited = "none";

/// Collects limits. Δt of each follows from a number that is proportional to it.
class Limits {
public:
    Limits(const Case& c, const Undisturbed& flow, Length dx, double tau)
        : case_(c), flow_(flow), dx_(dx.si), half_step_(tau - 0.5) {}

    /// Inertia of a flow at the shear rate `rate` around a cell, S ρ `rate` a²/μ, with what it is
    /// called.
    void add_reynolds(double rate, double of_one_percent, const char* number) {
        const double radius = equivalent_radius(case_).si, mu = viscosity();
        const double physical = density() * rate * radius * radius / mu;
        const double limit = tolerance() * per_percent * of_one_percent;
        // Below S = 1 there is nothing to gain.
        const double scale = std::max(1.0, limit / physical);
        add_accuracy(
            "Reynolds number", half_step_ * dx_ * dx_ * density() / (3.0 * mu) * scale,
            fmt::format("{} <= {:.2g} (physical: {:.2g}): inertia", number, limit, physical));
    }

    void add_flow_reynolds(bool inertia) {
        add_reynolds(flow_.shear_rate.si, reynolds_of_one_percent(carries_cells(case_), inertia),
                     "cell Reynolds number S rho k a^2 / mu");
    }

    void add_relaxation_reynolds() {
        add_reynolds(case_.membrane.shear_modulus.si / (viscosity() * equivalent_radius(case_).si),
                     relaxation_of_one_percent, "S rho E_s a / mu^2 of a cell that relaxes");
    }

    void add_delay() {
        const double limit = tolerance() * per_percent * delay_of_one_percent;
        const double radius = equivalent_radius(case_).si;
        add_accuracy("stress delay", limit * radius / (half_step_ * flow_.largest_speed.si),
                     fmt::format("(tau - 1/2) V dt / a <= {:.2g}: how far a cell is carried, in "
                                 "radii, while stress relaxes",
                                 limit));
    }

    void add_density_drop() {
        const double limit = tolerance() * per_percent * density_drop_of_one_percent;
        const double boxes = case_.domain.length.si / case_.domain.width.si;
        add_accuracy("density drop", limit / (12.0 * half_step_ * flow_.shear_rate.si * boxes),
                     fmt::format("12 (tau - 1/2) k dt length / width <= {:.2g}: what the pressure "
                                 "drop makes of the density, equilibrium full",
                                 limit));
    }

    void add_mach() {
        add("Mach number", auto_mach / std::sqrt(3.0) * dx_ / flow_.largest_speed.si,
            fmt::format("largest speed {} at Mach <= {}: stability",
                        rounded_text(flow_.largest_speed, 3), auto_mach));
    }

    void add_tension(const Membrane& membrane, double stretch) {
        const double slope = tension_slope(membrane, stretch);
        const double mean = 0.5 * (viscosity() + case_.cells.cytoplasm_viscosity.si);
        const bool implicit = tension_is_implicit(case_);
        const double most = implicit ? auto_implicit_tension_step_number : auto_tension_step_number;
        const double late =
            implicit ? auto_implicit_tension_step_number : auto_late_tension_step_number;
        add("membrane tension",
            std::min(most, late / half_step_) / tension_step_number(slope, mean, 1.5, 1.0, dx_),
            fmt::format("T' dt / (mu dx) <= {:.3g}, and {} over tau - 1/2: stability{}; T' at "
                        "stretch {:.3g} is {} times that at rest",
                        most, late, implicit ? ", tension implicit" : "", stretch,
                        rounded_text(slope / tension_slope(membrane, 1.0), Dimension{}, 3)));
    }

    void add_bending(const Membrane& membrane, double stretch) {
        const double modulus = bending_modulus(membrane, stretch_of_hardened(membrane, stretch));
        const double lesser = std::min(viscosity(), case_.cells.cytoplasm_viscosity.si);
        if (modulus == 0.0) return;
        add("bending", auto_bending_step_number / bending_step_number(modulus, lesser, 1.0, dx_),
            fmt::format("E_b dt / (mu dx^3) <= {}: stability; mu of the thinner fluid",
                        auto_bending_step_number));
    }

    /// The density is raised by S, and the flow then answers S times later, in S H²/(π² ν): no more
    /// than a share of 1/(2π f).
    void add_unsteady(double frequency, double width) {
        const double physical =
            2.0 * frequency * width * width * density() / (std::numbers::pi * viscosity());
        const double scale = 1.0 + tolerance() / physical;
        add_accuracy(
            "unsteady drive", half_step_ * dx_ * dx_ * density() / (3.0 * viscosity()) * scale,
            fmt::format("(S - 1) 2 f H^2 / (pi nu) <= {:.2g} (physical, at S = 1: {:.2g}): "
                        "how late the flow answers",
                        tolerance(), physical));
    }

    void add_physical() {
        add(unlimited, half_step_ * dx_ * dx_ * density() / (3.0 * viscosity()),
            "nothing moves: S = 1");
    }

    std::vector<StepLimit> sorted() && {
        std::sort(limits_.begin(), limits_.end(),
                  [](const auto& a, const auto& b) { return a.step.si < b.step.si; });
        return std::move(limits_);
    }
    bool empty() const { return limits_.empty(); }

private:
    void add(std::string name, double step, std::string reason, double change = 0.0) {
        limits_.push_back({std::move(name), Time{step}, std::move(reason), change});
    }
    void add_accuracy(std::string name, double step, std::string reason) {
        add(std::move(name), step, std::move(reason), tolerance());
    }
    double tolerance() const { return case_.numerics.step_tolerance; }
    double viscosity() const { return case_.plasma.viscosity.si; }
    double density() const { return case_.plasma.density.si; }

    const Case& case_;
    const Undisturbed& flow_;
    double dx_, half_step_;
    std::vector<StepLimit> limits_;
};

/// Of all that changes in time.
double highest_frequency(const Case& c) {
    double frequency = frequency_of(c.flow.waveform);
    for (const PortCase& port : c.ports)
        frequency = std::max(frequency, frequency_of(port.waveform));
    return frequency;
}

}  // namespace

Length equivalent_radius(const Case& c) {
    // The biconcave cell is named by its half length R₀; its area is 0.8916 R₀² (13.63 µm² at R₀
    // = 3.91 µm).
    if (std::holds_alternative<BiconcaveShape>(c.cells.shape))
        return Length{c.cells.radius.si * std::sqrt(0.8916 / std::numbers::pi)};
    return c.cells.radius;
}

bool carries_cells(const Case& c) {
    return (c.flow.channel() || c.network()) && !c.numerics.fluid_only;
}

double expected_stretch(const Case& c, const Undisturbed& flow, const Membrane& membrane) {
    if (c.numerics.fluid_only || c.membrane.rigid) return 1.0;
    const double modulus = c.membrane.shear_modulus.si;
    const double shear_number =
        c.plasma.viscosity.si * flow.wall_rate.si * equivalent_radius(c).si / modulus;
    const double in_flow = stretch_at(membrane, 3.5 * modulus * std::pow(shear_number, 0.8));
    return std::max(in_flow, std::sqrt(c.cells.initial_stretch.value_or(1.0)));
}

double stretch_of_hardened(const Membrane& membrane, double expected_stretch) {
    return membrane.hardening.shear ? expected_stretch : 1.0;
}

std::vector<StepLimit> step_limits(const Case& c, const Undisturbed& flow,
                                   const Equilibrium& equilibrium, Length dx, double tau,
                                   double stretch, const Membrane& membrane) {
    Limits limits(c, flow, dx, tau);
    const bool moves = flow.shear_rate.si > 0.0, cells = !c.numerics.fluid_only;
    const bool membranes = cells && !c.membrane.rigid;
    if (moves && cells)
        limits.add_flow_reynolds(!std::holds_alternative<LinearEquilibrium>(equilibrium));
    if (!moves && membranes) limits.add_relaxation_reynolds();
    if (moves && carries_cells(c)) limits.add_delay();
    if (moves && cells && std::holds_alternative<PressureDrive>(c.flow.drive) &&
        std::holds_alternative<FullEquilibrium>(equilibrium))
        limits.add_density_drop();
    if (moves) limits.add_mach();
    if (const double frequency = highest_frequency(c); moves && frequency > 0.0)
        limits.add_unsteady(frequency, c.domain.width.si);
    if (membranes) limits.add_tension(membrane, stretch);
    if (membranes) limits.add_bending(membrane, stretch);
    if (limits.empty()) limits.add_physical();
    return std::move(limits).sorted();
}

std::vector<StepLimit> tightest_of_kinds(const std::vector<std::vector<StepLimit>>& of_kinds,
                                         const std::vector<KindCase>& kinds) {
    if (of_kinds.size() == 1) return of_kinds.front();
    struct Tightest {
        StepLimit limit;
        std::size_t kind;
        Time longest;
    };
    std::vector<Tightest> found;
    for (std::size_t n = 0; n < of_kinds.size(); ++n)
        for (const StepLimit& limit : of_kinds[n]) {
            const auto same = std::find_if(found.begin(), found.end(), [&](const Tightest& other) {
                return other.limit.name == limit.name;
            });
            if (same == found.end()) {
                found.push_back({limit, n, limit.step});
                continue;
            }
            same->longest = std::max(same->longest, limit.step);
            if (limit.step < same->limit.step) *same = {limit, n, same->longest};
        }
    std::vector<StepLimit> limits;
    for (auto& [limit, kind, longest] : found) {
        if (limit.step < longest) limit.reason += fmt::format(" (kind '{}')", kinds[kind].name);
        limits.push_back(std::move(limit));
    }
    // What nothing asks of a rigid body at rest, a membrane beside it does.
    if (limits.size() > 1)
        std::erase_if(limits, [](const StepLimit& limit) { return limit.name == unlimited; });
    std::stable_sort(limits.begin(), limits.end(),
                     [](const StepLimit& a, const StepLimit& b) { return a.step < b.step; });
    return limits;
}

}  // namespace tt
