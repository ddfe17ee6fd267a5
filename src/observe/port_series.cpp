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
        header +=
            fmt::format(",{0}.flow_rate [{1}],{0}.pressure [{2}],{0}.cells_entered,{0}.cells_left",
                        name, si_unit(KinematicViscosity::dimension), si_unit(Pressure::dimension));
    table_.start(header + '\n');
}

void PortSeries::observe(const Snapshot& snapshot) {
    const Scales& scales = snapshot.model().scales;
    const double sampled = snapshot.model().boundaries.walls->sampled_flow();
    std::vector<std::int64_t> left(names_.size(), 0);
    for (const Departed& d : snapshot.state().departed) ++left[static_cast<std::size_t>(d.exit)];
    std::vector<std::size_t> entered(names_.size(), 0);
    for (std::size_t n = 0; n < snapshot.state().feeds.size(); ++n)
        entered[static_cast<std::size_t>(snapshot.model().feeds[n].port)] =
            snapshot.state().feeds[n].entered.size();
    std::string row = fmt::format("{},{}", snapshot.time().si, snapshot.step());
    for (std::size_t n = 0; n < names_.size(); ++n) {
        const PortFlow& port = snapshot.state().ports[n];
        const double pressure = port.mean_density() * d2q9::sound_speed_squared;
        fmt::format_to(std::back_inserter(row), ",{},{},{},{}",
                       scales.to_si<KinematicViscosity>(port.mean_inflow() / sampled).si,
                       scales.to_si<Pressure>(pressure).si, entered[n], left[n]);
    }
    table_.append(row + '\n');
}

}  // namespace tt
