#include "case/membrane_of.hpp"

#include <algorithm>

namespace tt {

Hardening hardening_of(const HardeningCase& h) {
    Hardening hardening;
    const auto applies = [&](Modality modality) {
        return std::find(h.apply_to.begin(), h.apply_to.end(), modality) != h.apply_to.end();
    };
    hardening.shear = applies(Modality::shear);
    hardening.bending = applies(Modality::bending);
    hardening.area = applies(Modality::area);
    hardening.contact = applies(Modality::contact);
    if (h.apply_to.empty()) return hardening;
    hardening.form = h.form;
    hardening.compression = h.compression;
    hardening.D = h.D;
    hardening.beta = h.beta;
    return hardening;
}

Membrane membrane_of(const MembraneCase& m, const Scales& scales) {
    Membrane membrane;
    membrane.rigid = m.rigid;
    membrane.in_plane = m.law;
    std::visit([&](auto& law) { law.shear_modulus = scales.to_lattice(m.shear_modulus); },
               membrane.in_plane);
    membrane.bending = m.bending;
    std::visit([&](auto& law) { law.modulus = scales.to_lattice(m.bending_modulus); },
               membrane.bending);
    membrane.hardening = hardening_of(m.hardening);
    membrane.hold_area = m.hold_area;
    membrane.viscosity = {scales.to_lattice(m.membrane_viscosity),
                          scales.to_lattice(m.bending_viscosity)};
    return membrane;
}

bool repels(const Case& c) {
    return c.contact.short_range_repulsion.value_or(!c.geometry.straight());
}

bool is_drop(const MembraneCase& m) { return std::holds_alternative<SurfaceTension>(m.law); }

bool tension_is_implicit(const Case& c) {
    return c.numerics.implicit_tension && !is_drop(c.membrane) && !c.membrane.rigid;
}

}  // namespace tt
