#include "observe/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <unistd.h>

#include <fmt/format.h>

#include "base/tell.hpp"
#include "base/units.hpp"
#include "io/json.hpp"

namespace tt {
namespace {

/// A path may hold bytes that are not UTF-8.
constexpr auto replace_bad_letters = Json::error_handler_t::replace;

/// Three digits: 0.12, 123, 12.3k, 1.23M.
std::string compact(double number) {
    if (number >= 1e6) return fmt::format("{:.3g}M", number * 1e-6);
    if (number >= 1e3) return fmt::format("{:.3g}k", number * 1e-3);
    return fmt::format("{:.3g}", number);
}

}  // namespace

std::string clock_text(double seconds) {
    if (!std::isfinite(seconds)) return "?";
    const auto total = static_cast<long long>(std::llround(std::min(seconds, 1e9)));
    if (total >= 2 * 86400) return fmt::format("{} d", total / 86400);
    if (total >= 3600)
        return fmt::format("{}:{:02}:{:02}", total / 3600, total % 3600 / 60, total % 60);
    return fmt::format("{}:{:02}", total / 60, total % 60);
}

std::string duration_text(double seconds) {
    if (seconds < 100.0) return rounded_text(seconds, Dimension{}, 2) + " s";
    if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
    if (seconds < 48.0 * 3600.0) return fmt::format("{:.1f} h", seconds / 3600.0);
    return fmt::format("{:.1f} days", seconds / 86400.0);
}

bool takes_long(double seconds) { return std::isfinite(seconds) && seconds >= 3600.0; }

std::string remark_on_length(double seconds) {
    return fmt::format(
        "About {} to the end at the speed measured. If that is too long, write a larger dx, a "
        "larger step_tolerance or an earlier end; a run that is stopped goes on later.",
        duration_text(seconds));
}

std::string progress_line(const Standing& s) {
    const double percent =
        s.steps > 0 ? 100.0 * static_cast<double>(s.step) / static_cast<double>(s.steps) : 100.0;
    std::string line =
        fmt::format("{:5.1f} %  {:.4g}/{:.4g} ms  {} steps/s  {} MLUPS", percent, s.time * 1e3,
                    s.end * 1e3, compact(s.steps_per_second), compact(s.mlups));
    if (s.cells > 0) line += fmt::format("  λ_C {:.3f}", s.lambda_C);
    return line + fmt::format("  {} left", clock_text(s.seconds_left));
}

std::string progress_json(const Standing& s) {
    const Json line{{"step", s.step},
                    {"steps", s.steps},
                    {"time", s.time},
                    {"end", s.end},
                    {"steps_per_second", s.steps_per_second},
                    {"mlups", s.mlups},
                    {"lambda_C", s.lambda_C},
                    {"wall_seconds", s.wall_seconds},
                    {"seconds_left", s.seconds_left}};
    return line.dump();
}

void write_messages_as_json() {
    message_writer = [](const std::string& text) {
        const std::string message = text.ends_with('\n') ? text.substr(0, text.size() - 1) : text;
        write_plainly(Json{{"message", message}}.dump(-1, ' ', false, replace_bad_letters) + '\n');
    };
}

Progress::Progress(ProgressMode mode) : mode_(mode) {
    if (mode_ == ProgressMode::automatic)
        mode_ = isatty(STDERR_FILENO) ? ProgressMode::bar : ProgressMode::log;
}

Progress::~Progress() {
    if (line_open_) std::fputs("\n", stderr);
}

double Progress::interval() const {
    switch (mode_) {
        case ProgressMode::bar:
            return 0.2;
        case ProgressMode::json:
            return 1.0;
        case ProgressMode::none:
            return std::numeric_limits<double>::infinity();
        default:
            return 10.0;
    }
}

void Progress::show(const Standing& standing) {
    show(progress_line(standing), progress_json(standing));
}

void Progress::show(const std::string& line, const std::string& json) {
    if (mode_ == ProgressMode::none) return;
    if (mode_ == ProgressMode::bar) {
        write_plainly("\r\x1b[K" + line);
        std::fflush(stderr);
        line_open_ = true;
        return;
    }
    write_plainly((mode_ == ProgressMode::json ? json : line) + '\n');
}

void Progress::say(const std::string& message) {
    if (line_open_) std::fputs("\r\x1b[K", stderr);
    line_open_ = false;
    if (mode_ != ProgressMode::none) tell_user("{}\n", message);
}

}  // namespace tt
