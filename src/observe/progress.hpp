#pragma once

#include <cstdio>
#include <string>

#include "observe/pace.hpp"

namespace tt {

/// One line rewritten 5 times a second on a terminal, a plain line every 10 s elsewhere
/// (`automatic` looks which it is), a line of JSON every second, or nothing.
enum class ProgressMode { automatic, bar, log, json, none };

/// `42.1 %  33.68/80 ms  1.23k steps/s  58.2 MLUPS  λ_C 1.086  3:12 left`, at most 79 columns.
std::string progress_line(const Standing& standing);
/// The same numbers as one JSON object without a line break.
std::string progress_json(const Standing& standing);

/// 3:12, 2:03:12 or 4 d; ? if it is not known.
std::string clock_text(double seconds);

/// 12 s, 31 min, 4.2 h or 3.1 days.
std::string duration_text(double seconds);

/// An hour and more.
bool takes_long(double seconds);
/// How long a run takes, and what to write where that is too long.
std::string remark_on_length(double seconds);

/// From here on each message is a line of JSON, {"message": …}, as those of progress are.
void write_messages_as_json();

/// Shows how a run goes, on stderr.
class Progress {
public:
    explicit Progress(ProgressMode mode);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Wall seconds between two lines; infinite for `none`.
    double interval() const;
    void show(const Standing& standing);
    /// The same for work that is no single run: `line`, or `json` where that is asked for.
    void show(const std::string& line, const std::string& json);
    /// A message of its own line that does not mix with the progress line.
    void say(const std::string& message);

private:
    ProgressMode mode_;
    bool line_open_ = false;
};

}  // namespace tt
