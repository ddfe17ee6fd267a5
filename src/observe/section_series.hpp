#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// sections.csv: of each section NAME the columns
///
///     NAME.flow_rate, NAME.mean_velocity, NAME.pressure   means of two steps and of the line
///     NAME.hematocrit_tube        share of the line that lies in cells
///     NAME.hematocrit_discharge   area of cells over volume that passed since the row before
///     NAME.cfl_from, NAME.cfl_to  from the wall at either end to the first membrane on the line
///     NAME.cells_forward, NAME.cells_backward             whose centroid has passed, since the
///     start NAME.cell_area, NAME.volume                         passed since the start, net
///
/// and of each stretch NAME.mu_rel, NAME.mu_app. NaN where it is not defined.
class SectionSeries : public Observer {
public:
    SectionSeries(const Schedule& schedule, const std::filesystem::path& directory,
                  const Model& model);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override { table_.sync(); }
    void save(ArchiveOutput& archive) const override;

private:
    void add_section(const Snapshot& snapshot, std::size_t n, std::string& row);

    const Model& model_;
    TableFile table_;
    std::vector<double> last_area_, last_volume_;  ///< of the row before, of each section
};

/// μ_rel of a stretch: Δp/Q over that of plasma alone.
double relative_viscosity(const Model& model, const State& state, const Stretch& stretch);

}  // namespace tt
