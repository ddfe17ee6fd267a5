#include "observe/status.hpp"

#include <ctime>

#include <unistd.h>

#include <fmt/format.h>

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
                      {"checkpoint_step", s.checkpoint_step},
                      {"pid", static_cast<std::int64_t>(getpid())},
                      {"updated", utc_now()}};
    write_json(results / "status.json", status, Durability::process);
}

Json read_status(const std::filesystem::path& results) {
    Json status = read_json(results / "status.json");
    if (status.value("status", std::string()) == "running" && !is_running(results))
        status["status"] = "interrupted";
    return status;
}

std::string describe_status(const Json& status) {
    Standing s;
    s.step = status.value("step", s.step);
    s.steps = status.value("steps", s.steps);
    s.time = status.value("time", s.time);
    s.end = status.value("end", s.end);
    s.steps_per_second = status.value("steps_per_second", s.steps_per_second);
    s.mlups = status.value("mlups", s.mlups);
    s.cells = status.value("cells", s.cells);
    s.lambda_C = status.value("lambda_C", s.lambda_C);
    s.seconds_left = status.value("seconds_left", s.seconds_left);
    const std::string phase = status.value("status", "unknown");
    std::string text =
        fmt::format("{}: {}\n{}\n", status.value("name", "?"), phase, progress_line(s));
    if (phase == "interrupted" || phase == "stopped") {
        text += fmt::format("run again to resume from step {}\n",
                            status.value("checkpoint_step", std::int64_t{-1}));
    }
    return text;
}

}  // namespace tt
