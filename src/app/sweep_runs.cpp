#include "app/sweep_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/case_options.hpp"
#include "base/error.hpp"
#include "case/discretise.hpp"
#include "case/initial_state.hpp"
#include "case/trial.hpp"
#include "case/resolve.hpp"
#include "case/write.hpp"
#include "observe/failure.hpp"
#include "observe/provenance.hpp"
#include "observe/status.hpp"
#include "simulation/stop.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Settings without the line of the name.
std::string nameless(const std::string& settings) {
    const std::size_t begin = settings.starts_with("name = ") ? 0 : settings.find("\nname = ") + 1;
    if (begin == 0 && !settings.starts_with("name = ")) return settings;
    return settings.substr(0, begin) + settings.substr(settings.find('\n', begin) + 1);
}

void expect_no_stop() {
    if (stop_requested())
        throw StoppedEarly("stopped before the first run; the same command begins again");
}

/// What is chosen for cases. The flow between walls takes a while, and no choice depends on a seed.
class Choices {
public:
    const Choice& of(Case c) {
        c.cells.seed = 0;
        const std::string key = key_lines(named_by_content(c));
        const auto known = known_.find(key);
        return known != known_.end() ? known->second : known_.emplace(key, choose(c)).first->second;
    }

private:
    std::map<std::string, Choice> known_;
};

/// Faults of runs, each told once with the runs that have it.
class RunFaults {
public:
    void add(const CaseError& error, const std::string& run) {
        for (const Fault& fault : error.faults()) {
            const auto same = [&](const auto& other) { return other.message == fault.message; };
            const auto known = std::find_if(found_.begin(), found_.end(), same);
            if (known == found_.end())
                found_.push_back({fault.message, run, 1});
            else
                ++known->runs;
        }
    }
    void throw_if_any() const {
        std::vector<Fault> faults;
        for (const Known& each : found_)
            faults.push_back(
                {each.first, 0, 0,
                 each.message +
                     (each.runs > 1 ? fmt::format(" (and in {} other runs)", each.runs - 1) : "")});
        if (!faults.empty()) throw CaseError(std::move(faults));
    }

private:
    struct Known {
        std::string message, first;
        int runs = 0;
    };
    std::vector<Known> found_;
};

/// Directories, sorted, so that the same is found every time.
std::set<fs::path> directories_in(const fs::path& folder) {
    std::set<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code ignored;
        if (at->is_directory(ignored)) found.insert(at->path());
    }
    return found;
}

/// Finished runs by their settings.
using Finished = std::map<std::string, fs::path>;

void add_finished(const fs::path& directory, Finished& finished) {
    if (!fs::exists(directory / "PROVENANCE.json") || !has_summary(directory)) return;
    const auto settings = recorded_settings(directory);
    if (settings && recorded_changes(directory).empty())
        finished.emplace(nameless(*settings), directory);
}

/// Those beside the directory of a sweep, and in runs/ of such directories.
Finished finished_beside(const fs::path& directory) {
    Finished finished;
    const fs::path folder = fs::absolute(directory / "").parent_path().parent_path();
    for (const fs::path& each : directories_in(folder)) {
        add_finished(each, finished);
        for (const fs::path& run : directories_in(each / "runs")) add_finished(run, finished);
    }
    return finished;
}

/// Throws DirectoryInUse if there are results of a case with which this one cannot go on. One that
/// blew up and was finished by hand with other numerics is the run that was asked for.
void expect_own(const SweepRun& run) {
    const auto recorded = recorded_settings(run.directory);
    if (!recorded) return;
    const std::string theirs = nameless(*recorded);
    if (recorded_changes(run.directory).empty())
        expect_same_case(run.directory, theirs, run.settings);
    else
        changed_numerics(run.directory, theirs, run.settings);
}

/// Is its directory that of a run with just these settings, and finished?
bool is_done(const SweepRun& run) {
    if (!has_summary(run.directory)) return false;
    const auto recorded = recorded_settings(run.directory);
    if (!recorded) return false;
    return nameless(*recorded) == run.settings || !recorded_changes(run.directory).empty();
}

}  // namespace

std::vector<SweepRun> locate_runs(const SweepPlan& plan, const fs::path& directory, Found found,
                                  const std::function<void(int)>& watch) {
    std::vector<SweepRun> runs;
    RunFaults faults;
    Choices choices;
    int looked_at = 0;
    for (const PlannedRun& planned : plan.runs) {
        expect_no_stop();
        watch(++looked_at);
        try {
            SweepRun run{&planned, choices.of(planned.c), {}, directory / "runs" / planned.name};
            expect_memory(planned.c, run.choice);
            run.settings = nameless(settings_of(planned.c, run.choice));
            runs.push_back(std::move(run));
        } catch (const CaseError& error) {
            faults.add(error, planned.name);
        }
    }
    faults.throw_if_any();
    if (found == Found::ignored) return runs;
    const bool all_done = std::all_of(runs.begin(), runs.end(), is_done);
    const Finished finished = all_done ? Finished{} : finished_beside(directory);
    for (SweepRun& run : runs) {
        if (is_done(run)) continue;
        const auto other = finished.find(run.settings);
        if (other != finished.end())
            run.directory = other->second;
        else
            expect_own(run);
    }
    return runs;
}

RunEnding ending_of(const SweepRun& run) {
    if (is_done(run)) return RunEnding::done;
    if (has_failed(run.directory)) return RunEnding::failed;
    return fs::exists(run.directory / "status.json") ? RunEnding::stopped : RunEnding::waiting;
}

void judge_new_runs(const std::vector<SweepRun>& runs, const std::function<void(int)>& watch) {
    RunFaults faults;
    int judged = 0;
    for (const SweepRun& run : runs) {
        if (ending_of(run) != RunEnding::waiting) continue;
        expect_no_stop();
        try {
            const Model model = discretise(run.plan->c, run.choice);
            expect_stable(run.plan->c, run.choice, model, initial_state(run.plan->c, model));
        } catch (const CaseError& error) {
            faults.add(error, run.plan->name);
        }
        watch(++judged);
    }
    faults.throw_if_any();
}

SweepRecord record_of(const SweepPlan& plan, const std::vector<SweepRun>& runs,
                      const fs::path& directory) {
    SweepRecord record{plan.name, plan.case_file.filename().string(), {}, {}};
    for (const SweepAxis& axis : plan.axes) {
        record.axes.emplace_back();
        for (const SweptKey& swept : axis.keys) record.axes.back().push_back(swept.key);
    }
    const fs::path here = fs::absolute(directory / "").parent_path();
    for (const SweepRun& run : runs) {
        SweptRun swept{run.plan->name, fs::absolute(run.directory).lexically_relative(here),
                       run.plan->values, ending_of(run), ""};
        if (swept.ending == RunEnding::failed) swept.why = failure_of(run.directory);
        record.runs.push_back(std::move(swept));
    }
    return record;
}

}  // namespace tt
