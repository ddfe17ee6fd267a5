#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "observe/observer.hpp"
#include "observe/table_file.hpp"

namespace tt {

/// A table with a row for each time that something happened to a cell, in the order of time. The
/// state keeps what happened, so nothing between two looks is lost; a look adds what is new.
class EventTable : public Observer {
public:
    /// The lines from event number `written` on, and how many these are.
    struct Lines {
        std::string text;
        std::int64_t count = 0;
    };
    using LinesFrom = std::function<Lines(const Snapshot&, std::int64_t written)>;

    EventTable(const Schedule& schedule, const std::filesystem::path& directory, std::string name,
               std::string header, LinesFrom lines);

    void start() override { table_.start(header_); }
    void resume(const ArchiveReader& archive) override;
    void observe(const Snapshot& snapshot) override;
    void sync() override { table_.sync(); }
    void save(ArchiveOutput& archive) const override;

private:
    std::string name_, header_;
    LinesFrom lines_;
    TableFile table_;
    std::int64_t written_ = 0;
};

}  // namespace tt
