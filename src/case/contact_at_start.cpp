#include "case/contact_at_start.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/kinds.hpp"
#include "case/step_limits.hpp"
#include "interaction/contact.hpp"

namespace tt {

std::optional<std::string> bursting_contact(const Case& c, const Model& model,
                                            const State& initial) {
    const std::vector<Morse> laws = model.contact.laws();
    if (laws.empty() || initial.cells.cell_count() == 0) return std::nullopt;
    // Nothing in the box is farther away than that.
    const double box = std::max(model.lattice.nx, model.lattice.ny);
    double reach = 0.0;
    for (const Morse& law : laws) reach = std::max(reach, law.zero_force_distance);
    reach = std::min(reach, box);
    const double gap = smallest_gap(model.lattice, initial.cells, reach);
    if (!(gap < reach)) return std::nullopt;
    double pressure = 0.0;  // may be infinite
    for (const Morse& law : laws)
        pressure =
            std::max(pressure, law.pressure(gap, 1.0) * model.scales.unit(Pressure::dimension));
    const double bearable = lysis_tension / largest_cell_radius(c).si;
    if (pressure <= bearable) return std::nullopt;
    return fmt::format(
        "Membranes start {} apart, where contact presses them with {:.2g} Pa; a cell bursts at "
        "some {:.2g} Pa. Write zero_force_distance = \"{}\", or give the cells more room.",
        rounded_text(Length{gap * model.scales.length}, 2), pressure, bearable,
        rounded_text(Length{std::max(1e-9, 0.9 * gap * model.scales.length)}, 2));
}

}  // namespace tt
