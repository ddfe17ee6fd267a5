#pragma once

#include <string_view>

#include "io/archive.hpp"
#include "observe/snapshot.hpp"
#include "simulation/schedule.hpp"

namespace tt {

/// Watches a run and writes what it sees; never changes it. Whatever it remembers from one look to
/// the next goes into the checkpoint, so that a run that was stopped and resumed leaves the same
/// files as one that was not.
class Observer {
public:
    explicit Observer(const Schedule& schedule) : schedule_(schedule) {}
    virtual ~Observer() = default;

    const Schedule& schedule() const { return schedule_; }

    /// Before the first step: makes its files anew.
    virtual void start() = 0;
    /// Instead of `start`: goes on from a checkpoint and drops what its files hold beyond it.
    virtual void resume(const ArchiveReader& archive) = 0;
    /// At a due step, and once more at the end of the run where that is not due.
    virtual void observe(const Snapshot& snapshot) = 0;
    /// Its files are on the disk, with all it has seen, when this returns.
    virtual void sync() {}
    /// What `resume` needs.
    virtual void save(ArchiveOutput& archive) const = 0;
    /// After the last step and its checkpoint.
    virtual void finish() {}

private:
    Schedule schedule_;
};

/// Of a checkpoint: an interval [s] that a Schedule can be made of. DamagedArchive if it is none.
double interval_in(const ArchiveReader& archive, std::string_view name);

}  // namespace tt
