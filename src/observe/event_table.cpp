#include "observe/event_table.hpp"

#include <utility>

namespace tt {

EventTable::EventTable(const Schedule& schedule, const std::filesystem::path& directory,
                       std::string name, std::string header, LinesFrom lines)
    : Observer(schedule),
      name_(std::move(name)),
      header_(std::move(header)),
      lines_(std::move(lines)),
      table_(directory, name_) {}

void EventTable::resume(const ArchiveReader& archive) {
    table_.resume(archive);
    written_ = archive.value<std::int64_t>(name_ + ".written");
}

void EventTable::observe(const Snapshot& snapshot) {
    const Lines lines = lines_(snapshot, written_);
    if (lines.count == 0) return;
    table_.append(lines.text);
    written_ += lines.count;
}

void EventTable::save(ArchiveOutput& archive) const {
    table_.save(archive);
    archive.put_value(name_ + ".written", written_);
}

}  // namespace tt
