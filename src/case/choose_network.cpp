#include "case/choose_network.hpp"

#include <algorithm>
#include <cmath>

#include "case/openings.hpp"
#include "case/port_figures.hpp"

namespace tt {

std::vector<PortCondition> slow_ports(const Case& c, const Choice& choice, const Walls& walls) {
    const double sampled = walls.sampled_flow();
    const std::vector<Opening>& openings = walls.solid.openings;  // [sites]
    const double dx = choice.dx.si, viscosity = c.plasma.viscosity.si;
    std::vector<PortCondition> conditions;
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        const PortCase& port = c.ports[n];
        if (port.pressure)
            conditions.push_back(
                HeldDensity{port.pressure->si * dx / viscosity / d2q9::sound_speed_squared});
        else if (port.flow_rate)
            conditions.push_back(HeldInflow{sampled * port.flow_rate->si / dx});
        else
            conditions.push_back(HeldInflow{sampled * port.mean_velocity.value_or(Velocity{}).si *
                                            width_of(openings[n])});
    }
    return conditions;
}

Undisturbed choose_network_flow(const Case& c, Choice& choice) {
    const UndisturbedFlow& plasma = *choice.undisturbed;
    for (std::size_t n = 0; n < c.ports.size(); ++n) {
        const PortFigures port = figures_of(c, choice, n);
        const double rate = std::fabs(port.mean_velocity.si) / port.width.si;
        choice.shear_rate.si = std::max(choice.shear_rate.si, rate);
    }
    choice.largest_speed = Velocity{plasma.fastest};
    return {choice.shear_rate, Rate{plasma.steepest / choice.dx.si}, choice.largest_speed};
}

}  // namespace tt
