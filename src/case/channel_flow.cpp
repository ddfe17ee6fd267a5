#include "case/channel_flow.hpp"

namespace tt {

Rate pseudo_shear_rate(const Case& c) {
    if (!c.flow.channel()) return {};
    const ChannelFlow& flow = *c.flow.channel();
    const double width = c.domain.width.si, viscosity = c.plasma.viscosity.si;
    if (flow.pseudo_shear_rate) return *flow.pseudo_shear_rate;
    if (flow.mean_velocity) return Rate{flow.mean_velocity->si / width};
    if (flow.largest_velocity) return Rate{flow.largest_velocity->si / (1.5 * width)};
    if (flow.flow_rate) return Rate{flow.flow_rate->si / (width * width)};
    if (flow.wall_stress) return Rate{flow.wall_stress->si / (6.0 * viscosity)};
    if (flow.pressure_gradient)
        return Rate{flow.pressure_gradient->si * width / (12.0 * viscosity)};
    return Rate{};
}

}  // namespace tt
