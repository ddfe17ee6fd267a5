#include "case/discretise.hpp"

#include <algorithm>
#include <cmath>

#include "case/choose_network.hpp"
#include "case/feeds.hpp"
#include "case/kinds.hpp"
#include "case/membrane_of.hpp"
#include "case/sections.hpp"
#include "membrane/implicit_tension.hpp"

namespace tt {
namespace {

/// Distance beyond r₀ at which the attraction has fallen to 1 % of its peak: with z = e^{−β(r−r₀)}
/// the force is ∝ z − z², largest ¼ at z = ½; 1 % of it at z = ½ (1 − √0.99).
double query_range(const MorseContact& contact) {
    const double z = 0.5 * (1.0 - std::sqrt(0.99));
    return contact.zero_force_distance.si - std::log(z) / contact.decay.si;
}

/// The law of [contact] as it is between two kinds.
MorseContact between(const Case& c, const MorseContact& morse, const std::string& a,
                     const std::string& b) {
    MorseContact own = morse;
    for (const ContactPairCase& pair : c.contact.pairs) {
        const auto& k = pair.kinds;
        if (!(k[0] == a && k[1] == b) && !(k[0] == b && k[1] == a)) continue;
        own.zero_force_distance = pair.zero_force_distance.value_or(own.zero_force_distance);
        own.decay = pair.decay.value_or(own.decay);
        own.energy = pair.energy.value_or(own.energy);
    }
    return own;
}

/// Sets what acts between membranes: one law, or one for each pair of kinds where they differ.
void set_morse(const Case& c, const MorseContact& morse, const Scales& scales,
               ContactModel& contact) {
    const std::vector<Case> kinds = cases_by_kind(c);
    contact.kinds = static_cast<int>(kinds.size());
    std::vector<Morse> laws;
    double range = 0.0;
    for (std::size_t a = 0; a < kinds.size(); ++a)
        for (std::size_t b = 0; b < kinds.size(); ++b) {
            const MorseContact law =
                c.kinds.empty() ? morse : between(c, morse, c.kinds[a].name, c.kinds[b].name);
            laws.push_back({scales.to_lattice(law.energy), scales.to_lattice(law.decay),
                            scales.to_lattice(law.zero_force_distance),
                            hardening_of(kinds[a].membrane.hardening).contact});
            range = std::fmax(range, query_range(law));
        }
    contact.law = laws.front();
    contact.range = scales.to_lattice(morse.range.value_or(Length{range}));
    const auto is_first = [&](const Morse& law) { return law == laws.front(); };
    if (!std::all_of(laws.begin(), laws.end(), is_first)) contact.pairs = std::move(laws);
}

ContactModel contact_of(const Case& c, const Scales& scales) {
    const ContactCase& k = c.contact;
    ContactModel contact;
    contact.nearest = k.nearest;
    if (const MorseContact* morse = k.morse()) set_morse(c, *morse, scales, contact);
    if (repels(c)) {
        contact.repulsion_range = k.repulsion_range ? scales.to_lattice(*k.repulsion_range) : 1.0;
        contact.repulsion_strength = scales.to_lattice(k.repulsion_strength);
    }
    return contact;
}

/// Steps between measurements of the gaps: up to four, of which the errors are not seen, as long as
/// the contact pressure moves two membranes half of r₀ apart by less than half of what changes it.
/// Every step where the short-range repulsion, which is far stiffer, may act. `alpha` is the
/// largest hardening expected.
int interval_of(const ContactModel& contact, double alpha, double viscosity) {
    constexpr double most = 4.0, share = 0.5;
    const std::vector<Morse> laws = contact.laws();
    if (laws.empty() || contact.repulsion_range > 0.0) return 1;
    double stiffness = 0.0;
    for (const Morse& law : laws)
        stiffness = std::fmax(stiffness, law.stiffness(0.5 * law.zero_force_distance,
                                                       law.scale_repulsion ? alpha : 1.0));
    return static_cast<int>(std::fmax(1.0, std::fmin(most, share * viscosity / stiffness)));
}

Waveform waveform_of(const WaveCase& wave, const Scales& scales) {
    Waveform waveform;
    if (const auto* sine = std::get_if<SineWave>(&wave)) {
        waveform.amplitude = sine->amplitude;
        waveform.frequency = scales.to_lattice(sine->frequency);
    } else if (const auto* table = std::get_if<TableWave>(&wave)) {
        for (const Time time : table->times) waveform.time.push_back(scales.to_lattice(time));
        waveform.factor = table->factors;
    }
    return waveform;
}

/// Of all ports, or none if all are steady.
std::vector<Waveform> port_waves(const Case& c, const Scales& scales) {
    std::vector<Waveform> waves;
    for (const PortCase& port : c.ports) waves.push_back(waveform_of(port.waveform, scales));
    const auto steady = [](const Waveform& wave) { return wave.steady(); };
    if (std::all_of(waves.begin(), waves.end(), steady)) waves.clear();
    return waves;
}

/// In lattice units.
std::vector<PortCondition> port_conditions(const Case& c, const Choice& choice, const Model& m) {
    std::vector<PortCondition> conditions = slow_ports(c, choice, *choice.walls);
    const double speed = m.scales.to_lattice(Velocity{1.0});
    for (PortCondition& condition : conditions) {
        if (auto* density = std::get_if<HeldDensity>(&condition))
            density->deviation *= speed * m.viscosity.plasma;
        else
            std::get<HeldInflow>(condition).rate *= speed;
    }
    return conditions;
}

/// Cells fade over two of their lengths where plasma leaves.
std::vector<Exit> exits_of(const Case& c, const Choice& choice) {
    if (c.numerics.fluid_only) return {};
    const double fade = 4.0 * largest_cell_radius(c).si / choice.dx.si;
    std::vector<Exit> exits;
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        const Opening& opening = choice.walls->solid.openings[n];
        const LatticeOpening& place = choice.walls->openings[n];
        const bool leaves = choice.undisturbed->ports[n].inflow < 0.0;
        exits.push_back({opening.from, opening.to,
                         Vec2{static_cast<double>(place.out_x), static_cast<double>(place.out_y)},
                         leaves ? fade : 0.0});
    }
    return exits;
}

ViscosityModel viscosity_of(const Case& c, const Choice& choice, const Scales& scales) {
    const NumericsCase& n = c.numerics;
    ViscosityModel viscosity;
    viscosity.interior = n.interior;
    viscosity.interface = n.interface_viscosity;
    viscosity.mean = n.viscosity_mean;
    viscosity.collision = n.collision;
    viscosity.plasma = (choice.relaxation_time - 0.5) / 3.0;
    viscosity.cytoplasm.clear();
    for (const Case& one : cases_by_kind(c))
        viscosity.cytoplasm.push_back(viscosity.plasma *
                                      (one.cells.cytoplasm_viscosity.si / c.plasma.viscosity.si));
    if (c.layer.thickness) {
        viscosity.layer_thickness = scales.to_lattice(*c.layer.thickness);
        viscosity.layer_viscosity =
            viscosity.plasma * (c.layer.viscosity->si / c.plasma.viscosity.si);
    }
    return viscosity;
}

std::vector<CellKind> kinds_of(const Case& c, const Choice& choice, const Model& m) {
    std::vector<CellKind> kinds;
    for (const Case& one : cases_by_kind(c)) {
        const std::size_t n = kinds.size();
        const double plasma = m.viscosity.plasma, cytoplasm = m.viscosity.cytoplasm[n];
        CellKind& kind = kinds.emplace_back();
        if (!c.kinds.empty()) kind.name = c.kinds[n].name;
        if (choice.jump_correction) kind.jump = jump_correction(m.delta, plasma, cytoplasm);
        kind.membrane = membrane_of(one.membrane, m.scales);
        if (tension_is_implicit(one))
            kind.membrane.mobility = tension_mobility(0.5 * (plasma + cytoplasm));
        kind.membrane.area_stiffness = m.scales.to_lattice(choice.kinds[n].area_stiffness);
    }
    return kinds;
}

}  // namespace

Model discretise(const Case& c, const Choice& choice) {
    Model m;
    m.lattice = lattice_of(c, choice);
    const double dx = choice.dx.si;
    m.scales = {dx, choice.dt.si, choice.density_scale * c.plasma.density.si * dx * dx * dx};
    m.density_scale = choice.density_scale;
    m.equilibrium = choice.equilibrium;
    m.precision = choice.precision;
    m.delta = choice.delta;
    m.viscosity = viscosity_of(c, choice, m.scales);
    m.kinds = kinds_of(c, choice, m);
    m.contact = contact_of(c, m.scales);
    double alpha = 0.0;
    for (std::size_t n = 0; n < m.kinds.size(); ++n)
        alpha = std::fmax(alpha, m.kinds[n].membrane.hardening(
                                     expected_cell_stretch(choice.kinds[n].expected_stretch)));
    m.contact.interval = interval_of(m.contact, alpha, m.viscosity.plasma);
    m.shear_rate = m.scales.to_lattice(choice.shear_rate);
    m.boundaries.walls = m.contact.walls = choice.walls;
    m.undisturbed = choice.undisturbed;
    if (m.undisturbed) m.drive.direction.y = m.undisturbed->lean;

    if (c.network()) {
        m.boundaries.ports = port_conditions(c, choice, m);
        for (const PortCase& port : c.ports) m.port_names.push_back(port.name);
        m.drive.target_velocity = m.scales.to_lattice(Velocity{1.0});
        m.exits = exits_of(c, choice);
        m.origin = choice.origin / choice.dx.si;
        m.port_waves = port_waves(c, m.scales);
        m.feeds = feeds_of(c, choice, m);
        for (std::size_t n = 0; n < m.feeds.size(); ++n)
            m.boundaries.ports[static_cast<std::size_t>(m.feeds[n].port)] =
                FedInflow{static_cast<int>(n), m.feeds[n].i, m.feeds[n].j};
    }
    m.sections = choice.sections;
    m.forks = forks_of(c, m.sections);
    m.stretches = stretches_of(c, choice);
    const double gradient = m.scales.to_lattice(choice.pressure_gradient);
    if (c.flow.shear()) {
        m.boundaries.top_speed = 0.5 * m.shear_rate * m.lattice.ny;
        m.boundaries.bottom_speed = -m.boundaries.top_speed;
    } else if (const ChannelFlow* channel = c.flow.channel()) {
        m.drive.hold_mean_velocity = channel->hold == Hold::mean_velocity;
        m.drive.target_velocity = m.shear_rate * m.lattice.ny;
        // A controller acts through the body force; a constant drop acts where the case says.
        // Between walls of any shape a force everywhere is the same flow as a drop at the ends.
        // So it is where the drop changes in time.
        m.drive.waveform = waveform_of(c.flow.waveform, m.scales);
        if (std::holds_alternative<PressureDrive>(c.flow.drive) && !m.drive.hold_mean_velocity &&
            !choice.walls && m.drive.waveform.steady()) {
            m.boundaries.pressure_drop = gradient * m.lattice.nx;
        } else {
            m.drive.body_force = gradient;
        }
    }
    return m;
}

}  // namespace tt
