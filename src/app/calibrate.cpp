#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/calibration.hpp"
#include "app/calibration_directory.hpp"
#include "app/option_values.hpp"
#include "base/undefined.hpp"
#include "base/tell.hpp"
#include "app/run_pool.hpp"
#include "app/run_request.hpp"
#include "app/verb.hpp"
#include "base/error.hpp"
#include "base/processors.hpp"
#include "base/units.hpp"
#include "case/resolve.hpp"
#include "case/write.hpp"
#include "io/checksum.hpp"
#include "io/file.hpp"
#include "io/json.hpp"
#include "observe/progress.hpp"
#include "observe/results_directory.hpp"
#include "report/gnuplot.hpp"

namespace tt {
namespace {

namespace fs = std::filesystem;

struct CalibrateOptions {
    std::string path;
    std::string directory;
    int jobs = 0;
    std::string progress = "auto";
    bool json = false;
};

/// To four digits, so that what is run is what a case file will say.
double rounded(double value) { return parse_measure(fmt::format("{:.4g}", value)).si; }

/// One calibration: from the targets to the pair, round by round.
class Calibrator {
public:
    Calibrator(const CalibrateOptions& options, const std::string& command_line)
        : calibration_(started(read_targets(options.path))),
          directory_(options.directory.empty() ? fs::path("results") / calibration_.targets.name
                                               : fs::path(options.directory),
                     calibration_.targets),
          at_once_(options.jobs > 0 ? options.jobs : usable_processors()),
          command_line_(command_line),
          progress_(progress_mode(options.progress)) {
        if (!directory_.moved_to().empty())
            progress_.say(fmt::format("moved the answer to other targets or inputs to '{}'",
                                      directory_.moved_to().string()));
    }

    /// exit_code::done, or why it did not come to its end.
    int run();
    const Calibration& calibration() const { return calibration_; }
    const fs::path& path() const { return directory_.path(); }

private:
    static Calibration started(Targets targets);
    TriedPair pair_at(Vec2 place) const;
    std::vector<Job> jobs_of(const TriedPair& pair) const;
    void read_answers(TriedPair& pair) const;
    int try_pairs(std::vector<TriedPair>& pairs);
    void tell_round();

    Calibration calibration_;
    CalibrationDirectory directory_;
    int at_once_;
    std::string command_line_;
    Progress progress_;
};

Calibration Calibrator::started(Targets targets) {
    std::vector<Goal> goals;
    for (const Target& target : targets.targets) goals.push_back(target.goal);
    std::vector<Vec2> given;
    const HardeningCase& own = targets.conditions.front().c.membrane.hardening;
    const Vec2 place{targets.D.place(own.D), targets.beta.place(own.beta)};
    const auto inside = [](double x) { return x >= 0.0 && x <= 1.0; };
    if (inside(place.x) && inside(place.y)) given.push_back(place);
    Search search(goals, targets.limits, given);
    return {std::move(targets), std::move(search), {}};
}

TriedPair Calibrator::pair_at(Vec2 place) const {
    const Targets& t = calibration_.targets;
    TriedPair pair;
    pair.D = rounded(t.D.value(place.x));
    pair.beta = rounded(t.beta.value(place.y));
    return pair;
}

/// All conditions with all seeds. A directory's name tells the pair and, by a checksum, all else,
/// so that runs of other targets may lie beside and serve where they are the same.
std::vector<Job> Calibrator::jobs_of(const TriedPair& pair) const {
    const Targets& t = calibration_.targets;
    std::vector<Job> jobs;
    for (const Condition& condition : t.conditions) {
        const std::vector<std::int64_t> own{condition.c.cells.seed};
        for (const std::int64_t seed : t.seeds.empty() ? own : t.seeds) {
            const Case c = case_at(condition, pair.D, pair.beta, seed);
            const std::string lines = key_lines(named_by_content(c));
            const std::string hash = hexadecimal(checksum(lines)).substr(0, 12);
            jobs.push_back(
                {directory_.path() / "runs" /
                     fmt::format("D{}-beta{}-{}", to_text(pair.D), to_text(pair.beta), hash),
                 c});
        }
    }
    return jobs;
}

void Calibrator::read_answers(TriedPair& pair) const {
    const Targets& t = calibration_.targets;
    const std::vector<Job> jobs = jobs_of(pair);
    const auto fail = [&](const std::string& why) {
        pair.failure = why;
        pair.found.clear();
        pair.scatter.clear();
    };
    for (const Job& job : jobs)
        if (end_of(job.directory) != JobEnd::done) return fail(failure_of(job.directory));
    const std::size_t seeds = jobs.size() / t.conditions.size();
    for (const Target& target : t.targets) {
        double sum = 0.0, squares = 0.0;
        for (std::size_t k = 0; k < seeds; ++k) {
            const fs::path& run = jobs[target.condition * seeds + k].directory;
            const Json mean = read_json(run / "summary.json").at(target.quantity).at("mean");
            if (!mean.is_number())
                return fail(fmt::format("{} is not defined in '{}'", target.quantity,
                                        run.filename().string()));
            sum += mean.get<double>();
            squares += mean.get<double>() * mean.get<double>();
        }
        const auto n = static_cast<double>(seeds);
        pair.found.push_back(sum / n);
        pair.scatter.push_back(
            seeds > 1 ? std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n - 1.0)) : undefined);
    }
}

int Calibrator::try_pairs(std::vector<TriedPair>& pairs) {
    std::vector<Job> jobs;
    int runs = 0;
    for (const TriedPair& pair : pairs)
        for (Job& job : jobs_of(pair)) {
            ++runs;
            if (end_of(job.directory) == JobEnd::none) jobs.push_back(std::move(job));
        }
    const int round = calibration_.search.rounds(), before = runs - static_cast<int>(jobs.size());
    PoolOptions options;
    options.at_once = at_once_;
    options.command_line = command_line_;
    options.interval = progress_.interval();
    options.show = [&](const PoolStanding& now) {
        progress_.show(fmt::format("round {}: {} of {} runs done, {} left in this round", round,
                                   before + now.ended, runs, clock_text(now.seconds_left)),
                       Json{{"round", round},
                            {"done", before + now.ended},
                            {"runs", runs},
                            {"seconds_left", now.seconds_left}}
                           .dump());
    };
    options.in_child = [&] { directory_.leave_to_parent(); };
    const int code = run_side_by_side(jobs, options);
    if (code != exit_code::done) return code;
    for (TriedPair& pair : pairs) {
        read_answers(pair);
        if (pair.found.empty())
            progress_.say(fmt::format("D = {}, beta = {} failed: {}", to_text(pair.D),
                                      to_text(pair.beta), pair.failure));
    }
    return exit_code::done;
}

void Calibrator::tell_round() {
    const Standpoint& now = calibration_.search.standpoint();
    const TriedPair& best = calibration_.best();
    if (best.found.empty()) return;
    progress_.say(fmt::format(
        "round {}: {} pairs; best D = {}, beta = {}, chi2 {:.3g}; minimum {:.2g} standard "
        "uncertainties from the nearest pair",
        calibration_.search.rounds() - 1, calibration_.pairs.size(), to_text(best.D),
        to_text(best.beta), misfit(best.found, calibration_.goals()), now.way));
}

int Calibrator::run() {
    Search& search = calibration_.search;
    while (!search.next().empty()) {
        std::vector<TriedPair> pairs;
        for (const Vec2 place : search.next()) pairs.push_back(pair_at(place));
        if (const int code = try_pairs(pairs); code != exit_code::done) return code;
        std::vector<Trial> trials;
        for (const TriedPair& pair : pairs)
            trials.push_back({calibration_.place(pair.D, pair.beta), pair.found});
        calibration_.pairs.insert(calibration_.pairs.end(), pairs.begin(), pairs.end());
        search.add(trials);
        tell_round();
    }
    return exit_code::done;
}

int calibrate(const CalibrateOptions& options, const std::string& command_line) {
    Calibrator calibrator(options, command_line);
    const std::string directory = calibrator.path().string();
    const int code = calibrator.run();
    if (code == exit_code::stopped_early)
        tell_user("stopped; the same command goes on in '{}'\n", directory);
    if (code != exit_code::done) return code;
    const Calibration& calibration = calibrator.calibration();
    if (calibration.best().found.empty()) {
        tell_user("tanktread: every pair failed: {}\n", calibration.best().failure);
        return exit_code::unstable;
    }
    const Json json = to_json(calibration);
    write_json(calibrator.path() / "calibration.json", json, Durability::power);
    fmt::print("{}", options.json ? json.dump(2) + "\n" : describe(calibration));
    std::fflush(stdout);  // before what goes to stderr
    make_directory(calibrator.path() / "figures");
    if (can_draw()) draw_valley(calibration, calibrator.path() / "figures");
    tell_user("in '{}': calibration.json{}\n", directory,
              can_draw() ? std::string(", figures/valley.svg") : fmt::format("\n{}", no_gnuplot));
    return exit_code::done;
}

}  // namespace

void add_calibrate(CLI::App& app, Action& action, const std::string& command_line) {
    auto options = std::make_shared<CalibrateOptions>();
    CLI::App* verb =
        app.add_subcommand("calibrate", "find the hardening's D and beta from measured numbers");
    verb->add_option("targets", options->path, "the file of targets")
        ->required()
        ->type_name(value_kind::toml_file);
    verb->add_option("-o,--output", options->directory, "directory; else results/NAME")
        ->type_name(value_kind::directory);
    verb->add_option("-j,--jobs", options->jobs,
                     "runs side by side, one thread each; else all processors")
        ->check(CLI::Range(1, 1024))
        ->type_name(value_kind::count);
    add_progress_option(*verb, options->progress);
    verb->add_flag("--json", options->json, "as JSON");
    verb->footer(
        "The file names a case, the ranges of D and beta, and the numbers to be met:\n\n"
        "  format = 1\n"
        "  case = \"channel.toml\"\n"
        "  set = [\"numerics.dx=0.4 um\"]             # as after --set, for every run\n"
        "  [search]\n"
        "  D = [0.1, 2]\n"
        "  beta = [8, 30]\n"
        "  seeds = [1, 2, 3]                        # averaged over\n"
        "  [[target]]                               # once for each number\n"
        "  quantity = \"lambda_C\"                    # mean of summary.json\n"
        "  value = 1.083\n"
        "  uncertainty = 0.0095                     # one standard deviation\n"
        "  set = [\"flow.pseudo_shear_rate=150 /s\"]\n\n"
        "Prints the pair with the least chi2, its uncertainty, the valley of pairs that\n"
        "are as good, and the lines for the case file. The same command goes on where it\n"
        "was stopped; no run is made twice. A pair that is unstable is left out and told.");
    verb->callback([options, &action, &command_line] {
        action = [options, &command_line] { return calibrate(*options, command_line); };
    });
}

}  // namespace tt
