#include "case/choose_network.hpp"

#include <algorithm>
#include <cmath>

#include "case/openings.hpp"

namespace tt {

std::vector<PortCondition> slow_ports(const Case& c, const Choice& choice, const Walls& walls) {
    const double sampled = walls.sampled_flow();
    const std::vector<Opening> openings = port_places(c).openings;
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
                                            width_of(openings[n]) / dx});
    }
    return conditions;
}

Undisturbed choose_network_flow(const Case& c, Choice& choice) {
    const UndisturbedFlow& plasma = *choice.undisturbed;
    const std::vector<Opening> openings = port_places(c).openings;
    for (std::size_t n = 0; n < openings.size(); ++n) {
        const double width = width_of(openings[n]);
        const double flow = std::fabs(plasma.ports[n].inflow) * choice.dx.si;
        const double rate = flow / choice.walls->sampled_flow() / (width * width);
        choice.shear_rate.si = std::max(choice.shear_rate.si, rate);
    }
    choice.largest_speed = Velocity{plasma.fastest};
    return {choice.shear_rate, Rate{plasma.steepest / choice.dx.si}, choice.largest_speed};
}

}  // namespace tt
