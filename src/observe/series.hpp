#pragma once

#include <filesystem>
#include <vector>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// series.csv, one row of RunMeasures a look, and cells.csv, one row of CellMeasures a cell and
/// look. Integrates the tank-treading phase of each cell from its rate by the trapezoidal rule over
/// the looks.
class Series : public Observer {
public:
    Series(const Schedule& schedule, const std::filesystem::path& directory);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override;
    void save(ArchiveOutput& archive) const override;

    /// DamagedArchive if what was saved cannot be of a run in `state`.
    static void examine(const ArchiveReader& archive, const State& state);

private:
    std::vector<CellMeasures> with_phase(const Snapshot& snapshot);

    TableFile series_, cells_;
    double last_time_ = 0.0;
    std::vector<double> phase_, last_rate_;  ///< per cell; empty before the first look
};

}  // namespace tt
