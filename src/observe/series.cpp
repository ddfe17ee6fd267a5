#include "observe/series.hpp"

#include <cmath>

#include <fmt/format.h>

#include "io/csv.hpp"

namespace tt {

Series::Series(const Schedule& schedule, const std::filesystem::path& directory)
    : Observer(schedule), series_(directory, "series"), cells_(directory, "cells") {}

void Series::start() {
    series_.start(csv_header<RunMeasures>());
    cells_.start(csv_header<CellMeasures>());
}

void Series::resume(const ArchiveReader& archive) {
    series_.resume(archive);
    cells_.resume(archive);
    last_time_ = archive.value<double>("series.last_time");
    phase_ = archive.take<double>("series.phase");
    last_rate_ = archive.take<double>("series.last_rate");
}

std::vector<CellMeasures> Series::with_phase(const Snapshot& snapshot) {
    std::vector<CellMeasures> cells = snapshot.cells();
    const double elapsed = snapshot.time().si - last_time_;
    for (CellMeasures& cell : cells) {
        const auto number = static_cast<std::size_t>(cell.cell);
        if (number < phase_.size()) {
            phase_[number] += 0.5 * (last_rate_[number] + cell.phase_rate.si) * elapsed;
        } else {  // the first look at it
            phase_.resize(number + 1, 0.0);
            last_rate_.resize(number + 1, 0.0);
        }
        last_rate_[number] = cell.phase_rate.si;
        cell.phase = phase_[number];
    }
    last_time_ = snapshot.time().si;
    return cells;
}

void Series::observe(const Snapshot& snapshot) {
    std::string rows;
    for (const CellMeasures& cell : with_phase(snapshot)) rows += csv_row(cell);
    cells_.append(rows);
    series_.append(csv_row(snapshot.run()));
}

void Series::sync() {
    series_.sync();
    cells_.sync();
}

void Series::save(ArchiveOutput& archive) const {
    series_.save(archive);
    cells_.save(archive);
    archive.put_value("series.interval", schedule().interval());
    archive.put_value("series.last_time", last_time_);
    archive.put("series.phase", phase_);
    archive.put("series.last_rate", last_rate_);
}

void Series::examine(const ArchiveReader& archive, const State& state) {
    interval_in(archive, "series.interval");
    if (!std::isfinite(archive.value<double>("series.last_time")))
        throw DamagedArchive("the checkpoint cannot be loaded: its last look has no time");
    const std::size_t cells =
        static_cast<std::size_t>(state.cells.cell_count()) + state.departed.size();
    const auto count = archive.take<double>("series.phase").size();
    // Cells may have come in since the last look.
    const bool possible = count == 0 || (state.feeds.empty() ? count == cells : count <= cells);
    if (!possible || archive.take<double>("series.last_rate").size() != count)
        throw DamagedArchive(
            "the checkpoint cannot be loaded: 'series.phase' is not of one number per cell");
}

}  // namespace tt
