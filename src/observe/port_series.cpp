#include "observe/port_series.hpp"

#include <iterator>

#include <fmt/format.h>

#include "base/units.hpp"

namespace tt {

PortSeries::PortSeries(const Schedule& schedule, const std::filesystem::path& directory,
                       const std::vector<std::string>& names)
    : Observer(schedule), names_(names), table_(directory, "ports") {}

void PortSeries::start() {
    std::string header = "time [s],step";
    for (const std::string& name : names_)
        header += fmt::format(",{0}.flow_rate [{1}],{0}.pressure [{2}]", name,
                              si_unit(KinematicViscosity::dimension), si_unit(Pressure::dimension));
    table_.start(header + '\n');
}

void PortSeries::observe(const Snapshot& snapshot) {
    const Scales& scales = snapshot.model().scales;
    const double sampled = snapshot.model().boundaries.walls->sampled_flow();
    std::string row = fmt::format("{},{}", snapshot.time().si, snapshot.step());
    for (const PortFlow& port : snapshot.state().ports)
        fmt::format_to(std::back_inserter(row), ",{},{}",
                       scales.to_si<KinematicViscosity>(port.mean_inflow() / sampled).si,
                       scales.to_si<Pressure>(port.mean_density() * d2q9::sound_speed_squared).si);
    table_.append(row + '\n');
}

}  // namespace tt
