#include "case/plausibility.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "base/units.hpp"
#include "case/kinds.hpp"
#include "case/membrane_of.hpp"

namespace tt {
namespace {

/// A number and where it usually lies: red blood cells in microvessels, microfluidic channels and
/// rheometers, with the width that parameter studies take.
struct Usual {
    std::string name;
    double value = 0.0;
    double low = 0.0, high = 0.0;
    Dimension dimension;
};

std::vector<Usual> numbers_of_flow(const Case& c, const Choice& choice) {
    const double k = std::abs(choice.shear_rate.si);
    std::vector<Usual> list{
        {"domain.width", c.domain.width.si, 2e-6, 2e-3, Length::dimension},
        {"domain.length", c.domain.length.si, 2e-6, 2e-2, Length::dimension},
        {"plasma.viscosity", c.plasma.viscosity.si, 3e-4, 0.1, Viscosity::dimension},
        {"plasma.density", c.plasma.density.si, 700.0, 1500.0, Density::dimension},
    };
    if (k == 0.0) return list;
    const bool shear = c.flow.shear() != nullptr;
    list.push_back(
        {shear ? "the shear rate" : "the pseudo-shear rate", k, 0.1, 2e4, Rate::dimension});
    list.push_back({"the largest speed", choice.largest_speed.si, 1e-7, 1.0, Velocity::dimension});
    return list;
}

void add_numbers_of_kind(const Case& c, std::vector<Usual>& list) {
    list.push_back({"cells.radius", c.cells.radius.si, 5e-7, 2e-5, Length::dimension});
    if (c.membrane.rigid) return;
    list.push_back({"cells.cytoplasm_viscosity", c.cells.cytoplasm_viscosity.si, 3e-4, 0.2,
                    Viscosity::dimension});
    list.push_back(
        {"membrane.shear_modulus", c.membrane.shear_modulus.si, 2e-7, 2e-3, Tension::dimension});
    // Without bending stiffness is a choice, not a slip.
    if (c.membrane.bending_modulus.si > 0.0)
        list.push_back({"membrane.bending_modulus", c.membrane.bending_modulus.si, 1e-21, 2e-17,
                        BendingModulus::dimension});
    if (const HardeningCase& hardening = c.membrane.hardening; !hardening.apply_to.empty()) {
        list.push_back({"membrane.hardening.D", hardening.D, 1e-3, 10.0, Dimension{}});
        list.push_back({"membrane.hardening.beta", hardening.beta, 0.1, 100.0, Dimension{}});
    }
}

std::vector<Usual> numbers_of_cells(const Case& c, const Appraisal& a) {
    std::size_t kind = 0;
    std::vector<Usual> list{{"the hematocrit", a.hematocrit, 0.0, 0.75, Dimension{}}};
    for (const Case& one : cases_by_kind(c)) {
        const std::size_t n = list.size();
        add_numbers_of_kind(one, list);
        if (c.kinds.empty()) continue;
        const std::string& name = c.kinds[kind++].name;
        for (std::size_t k = n; k < list.size(); ++k)
            list[k].name = fmt::format("{} of kind '{}'", list[k].name, name);
    }
    if (const MorseContact* morse = c.contact.morse(); morse && a.cells > 1) {
        list.push_back({"contact.zero_force_distance", morse->zero_force_distance.si, 1e-8, 2e-6,
                        Length::dimension});
        list.push_back({"contact.energy", morse->energy.si, 0.0, 1e-4, SurfaceEnergy::dimension});
        list.push_back({"contact.decay", morse->decay.si, 1e5, 1e8, InverseLength::dimension});
    }
    if (repels(c))
        list.push_back({"contact.repulsion_strength", c.contact.repulsion_strength.si, 0.0, 1e5,
                        decltype(c.contact.repulsion_strength)::dimension});
    if (a.shear_number > 0.0)
        list.push_back({"G = mu k a / E_s", a.shear_number, 1e-3, 20.0, Dimension{}});
    return list;
}

std::vector<Usual> numbers_of_output(const Case& c, const Appraisal& a) {
    return {
        {"the number of frames", static_cast<double>(a.frames), 0.0, 5000.0, Dimension{}},
        {"the disk needed [GB]", 1e-9 * static_cast<double>(a.disk_bytes), 0.0, 20.0, Dimension{}},
        {"the number of steps", static_cast<double>(a.steps), 0.0, 1e9, Dimension{}},
        {"output.checkpoint", c.output.checkpoint.si, 0.0, 86400.0, Time::dimension}};
}

void tell_unusual(const std::vector<Usual>& list, std::vector<Advice>& advice) {
    for (const Usual& number : list) {
        if (number.value >= number.low && number.value <= number.high) continue;
        const auto text = [&](double si) { return rounded_text(si, number.dimension, 3); };
        const std::string usual = number.low > 0.0
                                      ? fmt::format("{} to {}", text(number.low), text(number.high))
                                      : fmt::format("up to {}", text(number.high));
        advice.push_back({Advice::Weight::consider,
                          fmt::format("Unusual: {} is {}; {} is usual. Look at its unit.",
                                      number.name, text(number.value), usual)});
    }
}

}  // namespace

std::vector<Advice> implausible_numbers(const Case& c, const Choice& choice, const Appraisal& a) {
    std::vector<Advice> advice;
    tell_unusual(numbers_of_flow(c, choice), advice);
    if (a.cells > 0) tell_unusual(numbers_of_cells(c, a), advice);
    tell_unusual(numbers_of_output(c, a), advice);
    return advice;
}

}  // namespace tt
