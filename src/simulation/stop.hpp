#pragma once

namespace tt {

/// From now on INT, TERM, HUP, USR1, USR2 and XCPU only ask the run to stop, however often they
/// come. A second INT, a second or more after the first, ends the process at once. A HUP that the
/// caller ignores (nohup) stays ignored. Writing past a file-size limit becomes an error that we
/// report, instead of a signal that kills.
void catch_stop_signals();

/// Has a signal asked to stop?
bool stop_requested();

/// What a signal does, for callers that stop a run from inside the process.
void request_stop();

/// Forgets earlier requests, before another run in the same process.
void clear_stop_request();

}  // namespace tt
