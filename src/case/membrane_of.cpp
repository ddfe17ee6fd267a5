#include "case/membrane_of.hpp"

#include <algorithm>

namespace tt {

Hardening hardening_of(const HardeningCase& h) {
    Hardening hardening;
    const auto applies = [&](const char* modality) {
        return std::find(h.apply_to.begin(), h.apply_to.end(), modality) != h.apply_to.end();
    };
    hardening.shear = applies("shear");
    hardening.bending = applies("bending");
    hardening.area = applies("area");
    hardening.contact = applies("contact");
    if (h.apply_to.empty()) return hardening;
    hardening.form =
        h.form == "exponential" ? Hardening::Form::exponential : Hardening::Form::power_exponential;
    hardening.compression = h.compression == "one"          ? Hardening::Compression::one
                            : h.compression == "as-printed" ? Hardening::Compression::as_printed
                                                            : Hardening::Compression::symmetric;
    hardening.D = h.D;
    hardening.beta = h.beta;
    return hardening;
}

Membrane membrane_of(const MembraneCase& m, const Scales& scales) {
    const double modulus = scales.to_lattice(m.shear_modulus);
    const double bending = scales.to_lattice(m.bending_modulus);
    Membrane membrane;
    if (m.law == Hookean::name) {
        membrane.in_plane = Hookean{modulus};
    } else if (m.law == Skalak::name) {
        membrane.in_plane = Skalak{modulus, m.area_dilation_ratio};
    } else if (m.law == SurfaceTension::name) {
        membrane.in_plane = SurfaceTension{modulus};
    } else {
        membrane.in_plane = NeoHookean{modulus};
    }
    if (m.bending == ReferenceCurvature::name) {
        membrane.bending = ReferenceCurvature{bending};
    } else {
        membrane.bending = CurrentCurvature{bending};
    }
    membrane.hardening = hardening_of(m.hardening);
    membrane.hold_area = m.hold_area;
    return membrane;
}

}  // namespace tt
