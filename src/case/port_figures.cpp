#include "case/port_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "case/openings.hpp"

namespace tt {

PortFigures figures_of(const Case& c, const Choice& choice, std::size_t port) {
    const UndisturbedFlow::Port& plasma = choice.undisturbed->ports[port];
    const double width = width_of(choice.walls->solid.openings[port]) * choice.dx.si;
    const double flow = plasma.inflow * choice.dx.si / choice.walls->sampled_flow();
    const double pressure =
        plasma.density * d2q9::sound_speed_squared * c.plasma.viscosity.si / choice.dx.si;
    return {Length{width}, Pressure{pressure}, KinematicViscosity{flow}, Velocity{flow / width}};
}

Time late_answer(const Choice& choice) {
    const auto& ports = choice.undisturbed->ports;
    const auto [low, high] =
        std::minmax_element(ports.begin(), ports.end(),
                            [](const auto& a, const auto& b) { return a.density < b.density; });
    double passes = 0.0;
    for (const auto& port : ports) passes += 0.5 * std::fabs(port.inflow);
    if (!(passes > 0.0)) return {};
    const double viscosity = (choice.relaxation_time - 0.5) / 3.0;
    const double area = static_cast<double>(choice.walls->open_sites());
    const double steps = 0.5 * area * viscosity * (high->density - low->density) / passes;
    return Time{steps * choice.dt.si};
}

std::string late_answer_text(const Choice& choice) {
    const Time time = late_answer(choice);
    const double moved = time.si * choice.largest_speed.si;
    return fmt::format(
        "a change of the flow takes some {} to be felt everywhere, in which the "
        "fastest fluid moves {}; smaller with a shorter dt",
        rounded_text(time, 2), rounded_text(Length{moved}, 2));
}

}  // namespace tt
