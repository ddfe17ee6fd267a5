#include "observe/status.hpp"

#include <ctime>
#include <limits>

#include <unistd.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "observe/progress.hpp"
#include "observe/results_directory.hpp"

namespace tt {

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

void write_status(const std::filesystem::path& results, const Standing& s,
                  const std::string& phase) {
    const double percent =
        s.steps > 0 ? 100.0 * static_cast<double>(s.step) / static_cast<double>(s.steps) : 100.0;
    const Json status{{"name", s.name},
                      {"status", phase},
                      {"percent", percent},
                      {"step", s.step},
                      {"steps", s.steps},
                      {"time", s.time},
                      {"end", s.end},
                      {"wall_seconds", s.wall_seconds},
                      {"seconds_left", s.seconds_left},
                      {"steps_per_second", s.steps_per_second},
                      {"mlups", s.mlups},
                      {"lambda_C", s.lambda_C},
                      {"cells", s.cells},
                      {"threads", s.threads},
                      {"dx", s.dx},
                      {"checkpoint_step", s.checkpoint_step},
                      {"pid", static_cast<std::int64_t>(getpid())},
                      {"updated", utc_now()}};
    write_json(results / "status.json", status, Durability::process);
}

Json recorded_status(const std::filesystem::path& results) {
    try {
        Json status = read_json(results / "status.json");
        if (status.is_object()) return status;
    } catch (const IoError&) {
    }
    return Json::object();
}

Json read_status(const std::filesystem::path& results) {
    if (!std::filesystem::is_directory(results))
        throw IoError(results.string() + ": no such results directory");
    if (!std::filesystem::exists(results / "status.json"))
        throw IoError(results.string() +
                      ": holds no results (no status.json); give a directory that `tanktread run` "
                      "wrote");
    Json status = read_json(results / "status.json");
    const std::string phase = status.value("status", std::string());
    const bool done = phase == "done" && std::filesystem::exists(results / "summary.json");
    if (phase == "running" || (phase == "done" && !done))
        status["status"] = is_running(results) ? "running" : "interrupted";
    const auto has = [&](const char* name) {
        return std::filesystem::exists(results / "checkpoint" / name);
    };
    if (status.value("checkpoint_step", std::int64_t{-1}) >= 0 && !has("current") &&
        !has("previous"))
        status["checkpoint_gone"] = true;
    return status;
}

namespace {

/// A number of the status; JSON has no infinity and writes null for it.
double number(const Json& status, const char* key, double otherwise) {
    const auto found = status.find(key);
    return found != status.end() && found->is_number() ? found->get<double>() : otherwise;
}

}  // namespace

std::string describe_status(const Json& status) {
    Standing s;
    s.step = status.value("step", s.step);
    s.steps = status.value("steps", s.steps);
    s.time = number(status, "time", s.time);
    s.end = number(status, "end", s.end);
    s.steps_per_second = number(status, "steps_per_second", s.steps_per_second);
    s.mlups = number(status, "mlups", s.mlups);
    s.cells = status.value("cells", s.cells);
    s.lambda_C = number(status, "lambda_C", s.lambda_C);
    s.seconds_left = number(status, "seconds_left", std::numeric_limits<double>::infinity());
    const std::string phase = status.value("status", "unknown");
    std::string text =
        fmt::format("{}: {}\n{}\n", status.value("name", "?"), phase, progress_line(s));
    if (phase == "interrupted" || phase == "stopped") {
        const auto step = status.value("checkpoint_step", std::int64_t{-1});
        if (status.value("checkpoint_gone", false))
            return text + "its checkpoint is gone: it cannot go on, but report and export work\n";
        text += step > 0 ? fmt::format("run again to resume from step {}\n", step)
                         : "run again; it begins at step 0\n";
    }
    if (phase == "failed")
        text += "it blew up: failure/why.txt says why, tanktread report shows where\n";
    return text;
}

}  // namespace tt
