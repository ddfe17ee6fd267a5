#include "app/sweep_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/words.hpp"
#include "io/file.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

/// Of this very program.
std::string program() {
    std::error_code error;
    const fs::path path = fs::read_symlink("/proc/self/exe", error);
    return shell_quoted(error ? std::string("tanktread") : path.string());
}

fs::path absolute_of(const fs::path& directory) {
    return fs::absolute(directory / "").lexically_normal().parent_path();
}

/// More indices than Slurm takes by default (MaxArraySize) must be several runs a task.
constexpr std::size_t most_tasks = 1000;

constexpr const char* array_script = R"(#!/bin/bash
#SBATCH --job-name={name}
#SBATCH --array=0-{last}
#SBATCH --cpus-per-task=1
#SBATCH --time={minutes}
#SBATCH --signal=B:USR2@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output={directory}/slurm-%a.log
# Each task makes {each} of the runs in commands.txt. One that is stopped at its limit goes on in the queue.
cd {here} || exit 5
worst=0
run=
asked=
trap 'asked=1; [ -n "$run" ] && kill -USR2 "$run" 2>/dev/null' USR2 TERM
for ((k = 1; k <= {each}; ++k)); do
    line=$(sed -n "$((SLURM_ARRAY_TASK_ID * {each} + k))p" {commands})
    [ -n "$line" ] || break
    code=75
    if [ -z "$asked" ]; then
        bash -c "exec $line" < /dev/null &
        run=$!
        wait "$run"
        code=$?
        while [ $code -gt 128 ] && kill -0 "$run" 2>/dev/null; do
            wait "$run"
            code=$?
        done
        run=
    fi
    if [ $code = 75 ] || {{ [ -n "$asked" ] && [ $code -gt 128 ]; }}; then
        scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID"
        sleep 60
        exit 75
    fi
    [ $code -gt $worst ] && worst=$code
done
exit $worst
)";

constexpr const char* report_script = R"(#!/bin/bash
#SBATCH --job-name={name}-report
#SBATCH --time=10
#SBATCH --open-mode=append
#SBATCH --output={directory}/slurm-report.log
cd {here} || exit 5
exec {program} sweep {sweep} --gather
)";

}  // namespace

std::string commands_of(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                        const fs::path& directory) {
    const fs::path here = absolute_of(directory);
    const std::string begin =
        fmt::format("{} run {}", program(),
                    shell_quoted((here / "inputs" / plan.case_file.filename()).string()));
    std::string lines;
    for (const SweepRun* run : runs) {
        lines += begin;
        for (const std::string& setting : run->plan->settings)
            lines += " --set " + shell_quoted(setting);
        lines += fmt::format(" -o {} -j 1 --progress log\n",
                             shell_quoted((here / "runs" / run->plan->name).string()));
    }
    return lines;
}

std::string write_parallel(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                           const fs::path& directory, int at_once) {
    const fs::path commands = directory / "commands.txt";
    replace_file(commands, commands_of(plan, runs, directory), Durability::process);
    return fmt::format("parallel -u -j {} --termseq TERM,60000,KILL < {}\n", at_once,
                       shell_quoted(commands.string()));
}

std::string write_slurm(const SweepPlan& plan, const std::vector<const SweepRun*>& runs,
                        const fs::path& directory, int minutes) {
    const fs::path here = absolute_of(directory);
    const std::size_t each = std::max<std::size_t>((runs.size() + most_tasks - 1) / most_tasks, 1);
    const std::size_t tasks = (runs.size() + each - 1) / each;
    std::string name = plan.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    replace_file(directory / "commands.txt", commands_of(plan, runs, directory),
                 Durability::process);
    using fmt::arg;
    const std::string cwd = shell_quoted(fs::current_path().string());
    replace_file(directory / "slurm.sh",
                 fmt::format(fmt::runtime(array_script), arg("name", name), arg("last", tasks - 1),
                             arg("minutes", minutes), arg("directory", here.string()),
                             arg("each", each), arg("here", cwd),
                             arg("commands", shell_quoted((here / "commands.txt").string()))),
                 Durability::process);
    replace_file(directory / "slurm-report.sh",
                 fmt::format(fmt::runtime(report_script), arg("name", name),
                             arg("directory", here.string()), arg("here", cwd),
                             arg("program", program()), arg("sweep", shell_quoted(here.string()))),
                 Durability::process);
    return fmt::format("job=$(sbatch --parsable {})\nsbatch --dependency=afterany:$job {}\n",
                       shell_quoted((directory / "slurm.sh").string()),
                       shell_quoted((directory / "slurm-report.sh").string()));
}

}  // namespace tt
