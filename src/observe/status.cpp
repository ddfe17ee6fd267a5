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

bool has_summary(const std::filesystem::path& results) {
    return !read_object(results / "summary.json").empty();
}

Json recorded_status(const std::filesystem::path& results) {
    return read_object(results / "status.json");
}

Json read_status(const std::filesystem::path& results) {
    if (!std::filesystem::is_directory(results))
        throw IoError(results.string() + ": no such results directory");
    if (!std::filesystem::exists(results / "status.json"))
        throw IoError(results.string() +
                      ": holds no results (no status.json); give a directory that `tanktread run` "
                      "wrote");
    Json status = read_json(results / "status.json");
    if (!status.is_object())
        throw IoError(fmt::format("'{}' is damaged", (results / "status.json").string()));
    const std::string phase = text_of(status, "status");
    const bool done = phase == "done" && has_summary(results);
    if (phase == "running" || (phase == "done" && !done))
        status["status"] = is_running(results) ? "running" : "interrupted";
    const auto has = [&](const char* name) {
        return std::filesystem::exists(results / "checkpoint" / name);
    };
    if (whole_number_of(status, "checkpoint_step", -1) >= 0 && !has("current") && !has("previous"))
        status["checkpoint_gone"] = true;
    return status;
}

std::string describe_status(const Json& status) {
    Standing s;
    s.step = whole_number_of(status, "step", s.step);
    s.steps = whole_number_of(status, "steps", s.steps);
    s.time = number_of(status, "time", s.time);
    s.end = number_of(status, "end", s.end);
    s.steps_per_second = number_of(status, "steps_per_second", s.steps_per_second);
    s.mlups = number_of(status, "mlups", s.mlups);
    s.cells = static_cast<int>(whole_number_of(status, "cells", s.cells));
    s.lambda_C = number_of(status, "lambda_C", s.lambda_C);
    s.seconds_left = number_of(status, "seconds_left", std::numeric_limits<double>::infinity());
    const std::string phase = text_of(status, "status", "unknown");
    std::string text =
        fmt::format("{}: {}\n{}\n", text_of(status, "name", "?"), phase, progress_line(s));
    if (phase == "interrupted" || phase == "stopped") {
        const auto step = whole_number_of(status, "checkpoint_step", -1);
        if (status.contains("checkpoint_gone"))
            return text + "its checkpoint is gone: it cannot go on, but report and export work\n";
        text += step > 0 ? fmt::format("run again to resume from step {}\n", step)
                         : "run again; it begins at step 0\n";
    }
    if (phase == "failed")
        text += "it blew up: failure/why.txt says why, tanktread report shows where\n";
    return text;
}

}  // namespace tt
