#include "case/contact_at_start.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/step_limits.hpp"
#include "interaction/contact.hpp"

namespace tt {

std::optional<std::string> bursting_contact(const Case& c, const Model& model,
                                            const State& initial) {
    const auto* morse = std::get_if<Morse>(&model.contact.law);
    if (!morse || initial.cells.cell_count() == 0) return std::nullopt;
    // Nothing in the box is farther away than that.
    const double box = std::max(model.lattice.nx, model.lattice.ny);
    const double reach = std::min(morse->zero_force_distance, box);
    const double gap = smallest_gap(model.lattice, initial.cells, reach);
    if (!(gap < reach)) return std::nullopt;
    const double pressure =
        morse->pressure(gap, 1.0) * model.scales.unit(Pressure::dimension);  // may be infinite
    const double bearable = lysis_tension / equivalent_radius(c).si;
    if (pressure <= bearable) return std::nullopt;
    return fmt::format(
        "Membranes start {} apart, where contact presses them with {:.2g} Pa; a cell bursts at "
        "some {:.2g} Pa. Write zero_force_distance = \"{}\", or give the cells more room.",
        rounded_text(Length{gap * model.scales.length}, 2), pressure, bearable,
        rounded_text(Length{std::max(1e-9, 0.9 * gap * model.scales.length)}, 2));
}

}  // namespace tt
