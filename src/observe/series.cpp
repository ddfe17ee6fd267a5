#include "observe/series.hpp"

#include "io/csv.hpp"

namespace tt {

Series::Series(const Schedule& schedule, const std::filesystem::path& directory)
    : Observer(schedule), directory_(directory) {}

void Series::start() {
    series_.emplace(directory_ / "series.csv", OutputFile::Mode::append);
    series_->cut(0);
    series_->append(csv_header<RunMeasures>());
    cells_.emplace(directory_ / "cells.csv", OutputFile::Mode::append);
    cells_->cut(0);
    cells_->append(csv_header<CellMeasures>());
}

void Series::resume(const ArchiveReader& archive) {
    series_.emplace(directory_ / "series.csv", OutputFile::Mode::append);
    series_->cut(archive.value<std::int64_t>("series.size"));
    cells_.emplace(directory_ / "cells.csv", OutputFile::Mode::append);
    cells_->cut(archive.value<std::int64_t>("cells.size"));
    last_time_ = archive.value<double>("series.last_time");
    phase_ = archive.take<double>("series.phase");
    last_rate_ = archive.take<double>("series.last_rate");
}

std::vector<CellMeasures> Series::with_phase(const Snapshot& snapshot) {
    std::vector<CellMeasures> cells = snapshot.cells();
    const double elapsed = snapshot.time().si - last_time_;
    const bool first = phase_.empty();
    phase_.resize(cells.size(), 0.0);
    last_rate_.resize(cells.size(), 0.0);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (!first) phase_[c] += 0.5 * (last_rate_[c] + cells[c].phase_rate.si) * elapsed;
        last_rate_[c] = cells[c].phase_rate.si;
        cells[c].phase = phase_[c];
    }
    last_time_ = snapshot.time().si;
    return cells;
}

void Series::observe(const Snapshot& snapshot) {
    std::string rows;
    for (const CellMeasures& cell : with_phase(snapshot)) rows += csv_row(cell);
    cells_->append(rows);
    series_->append(csv_row(snapshot.run()));
}

void Series::sync() {
    series_->sync();
    cells_->sync();
}

void Series::save(ArchiveOutput& archive) const {
    archive.put_value("series.size", series_->size());
    archive.put_value("cells.size", cells_->size());
    archive.put_value("series.interval", schedule().interval());
    archive.put_value("series.last_time", last_time_);
    archive.put("series.phase", phase_);
    archive.put("series.last_rate", last_rate_);
}

}  // namespace tt
