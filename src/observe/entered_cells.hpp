#pragma once

#include <filesystem>
#include <vector>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// entered.csv: one row a cell that came in through a port.
class EnteredCells : public Observer {
public:
    EnteredCells(const Schedule& schedule, const std::filesystem::path& directory);

    void start() override;
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override { table_.sync(); }
    void save(ArchiveOutput& archive) const override;

private:
    TableFile table_;
    std::int64_t written_ = 0;  ///< of all feeds together
};

}  // namespace tt
