#pragma once

#include <cstdint>
#include <filesystem>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// left.csv: a row for each cell that left through a port, when and where, in the order in which
/// they did.
class LeftCells : public Observer {
public:
    LeftCells(const Schedule& schedule, const std::filesystem::path& directory);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override { table_.sync(); }
    void save(ArchiveOutput& archive) const override;

private:
    TableFile table_;
    std::int64_t written_ = 0;  ///< of the departures of the state
};

}  // namespace tt
