#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// ports.csv: of each port NAME the columns NAME.flow_rate, into the channels and per depth, and
/// NAME.pressure, each the mean of two steps, and NAME.cells_left so far. What goes in comes out:
/// the flow rates add up to nothing once the flow is steady.
class PortSeries : public Observer {
public:
    PortSeries(const Schedule& schedule, const std::filesystem::path& directory,
               const std::vector<std::string>& names);

    void start() override;
    void resume(const ArchiveReader& archive) override { table_.resume(archive); }
    void observe(const Snapshot& snapshot) override;
    void sync() override { table_.sync(); }
    void save(ArchiveOutput& archive) const override { table_.save(archive); }

private:
    std::vector<std::string> names_;
    TableFile table_;
};

}  // namespace tt
