#include "case/planned_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "case/kept_inputs.hpp"
#include "case/read.hpp"
#include "case/resolve.hpp"
#include "case/sweep_names.hpp"
#include "case/write.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Makes the runs of a plan whose axes are known, gathering faults.
class Planner {
public:
    Planner(SweepPlan& plan, const std::vector<CommonSetting>& set, std::vector<Fault>& faults)
        : plan_(plan), set_(set), faults_(faults) {}

    void expand();

private:
    void judge_keys();
    PlannedRun run_at(std::size_t number) const;
    void tell(const CaseError& error, const PlannedRun& run);
    void tell_those_of_some_runs();
    void expect_different_runs();

    SweepPlan& plan_;
    const std::vector<CommonSetting>& set_;
    std::vector<Fault>& faults_;
    std::set<std::pair<std::string, std::string>> told_;  ///< key and message
    /// Faults of the case: in how many runs, and in which first.
    struct Seen {
        Fault fault;
        std::size_t runs = 0;
        std::string first;
    };
    std::map<std::string, Seen> seen_;
};

std::size_t count_of(const std::vector<SweepAxis>& axes) {
    double count = 1.0;
    for (const SweepAxis& axis : axes) count *= static_cast<double>(axis.size());
    return count > 1e15 ? most_runs + 1 : static_cast<std::size_t>(count);
}

/// A key belongs to one axis.
void Planner::judge_keys() {
    std::set<std::string> known;
    for (const SweepAxis& axis : plan_.axes)
        for (const SweptKey& swept : axis.keys) {
            plan_.keys.push_back(swept.key);
            if (known.insert(swept.key).second || swept.values.empty()) continue;
            faults_.push_back(swept.values.front().place);
            faults_.back().message = swept.key + " belongs to another axis already";
        }
    if (const std::size_t count = count_of(plan_.axes); count > most_runs)
        faults_.push_back(
            {"", 0, 0,
             fmt::format("these axes make more than {} runs; take fewer values", most_runs)});
}

/// Without its case. The last axis changes fastest.
PlannedRun Planner::run_at(std::size_t number) const {
    PlannedRun run;
    for (const CommonSetting& each : set_) run.settings.push_back(each.text);
    std::size_t places = count_of(plan_.axes);
    for (const SweepAxis& axis : plan_.axes) {
        places /= axis.size();
        const std::size_t place = number / places;
        number %= places;
        for (const SweptKey& swept : axis.keys) {
            const SweepValue& value = swept.values[place];
            run.values.push_back(value.text);
            run.settings.push_back(swept.key + "=" + value.setting);
        }
    }
    return run;
}

/// A fault of a setting belongs to where that was written; the same of several values is told once.
void Planner::tell(const CaseError& error, const PlannedRun& run) {
    for (const Fault& fault : error.faults()) {
        const auto tell_at = [&](const Fault& place, const std::string& key) {
            if (!told_.emplace(key, fault.message).second) return;
            faults_.push_back(place);
            faults_.back().message = fault.message;
        };
        bool placed = false;
        for (const CommonSetting& each : set_)
            if (fault.file == origin_of(each.text)) tell_at(each.place, each.text), placed = true;
        for (const SweepAxis& axis : plan_.axes)
            for (const SweptKey& swept : axis.keys)
                for (const SweepValue& value : swept.values)
                    if (fault.file == origin_of(swept.key + "=" + value.setting))
                        tell_at(value.place, swept.key), placed = true;
        if (placed) continue;
        Seen& seen = seen_[to_string(fault)];
        if (seen.runs++ == 0) seen.fault = fault, seen.first = run.name;
    }
}

void Planner::tell_those_of_some_runs() {
    for (auto& [text, seen] : seen_) {
        if (seen.runs < plan_.runs.size())
            seen.fault.message += fmt::format(" (in {} of {} runs, first {})", seen.runs,
                                              plan_.runs.size(), seen.first);
        faults_.push_back(seen.fault);
    }
}

void Planner::expect_different_runs() {
    std::map<std::string, const PlannedRun*> known;
    for (const PlannedRun& run : plan_.runs) {
        const auto [at, fresh] = known.emplace(key_lines(named_by_content(run.c)), &run);
        if (fresh) continue;
        faults_.push_back({"", 0, 0,
                           fmt::format("{} and {} are the same run; leave one of them out",
                                       at->second->name, run.name)});
    }
}

void Planner::expand() {
    // Told already; the others are looked at without them.
    std::erase_if(plan_.axes, [](const SweepAxis& axis) {
        const auto odd = [&](const SweptKey& swept) { return swept.values.size() != axis.size(); };
        return axis.size() == 0 || std::any_of(axis.keys.begin(), axis.keys.end(), odd);
    });
    judge_keys();
    if (count_of(plan_.axes) > most_runs) return;
    const std::string text = read_file(plan_.case_file, Author::user);
    const fs::path folder = fs::absolute(plan_.case_file).parent_path();
    const std::size_t count = count_of(plan_.axes);
    for (std::size_t k = 0; k < count; ++k) plan_.runs.push_back(run_at(k));
    name_runs(plan_);
    for (PlannedRun& run : plan_.runs) {
        try {
            run.c = parse_case(text, plan_.case_file.string(), run.settings, folder);
        } catch (const CaseError& error) {
            tell(error, run);
        }
    }
    tell_those_of_some_runs();
    if (!faults_.empty()) return;
    expect_different_runs();
    std::vector<const Case*> cases;
    for (const PlannedRun& run : plan_.runs) cases.push_back(&run.c);
    plan_.inputs = kept_inputs(plan_.case_file, text, cases);
}

}  // namespace

void make_runs(SweepPlan& plan, const std::vector<CommonSetting>& set, std::vector<Fault>& faults) {
    Planner(plan, set, faults).expand();
}

}  // namespace tt
