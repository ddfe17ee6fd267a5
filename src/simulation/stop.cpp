#include "simulation/stop.hpp"

#include <atomic>
#include <csignal>
#include <ctime>
#include <initializer_list>

namespace tt {
namespace {

// Counted by a handler, on whatever thread, and looked at by all.
std::atomic<int> requests{0};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);
timespec first_interrupt{};  // written once, by the first INT, while INT is blocked

double seconds_since(const timespec& start) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec - start.tv_sec) +
           1e-9 * static_cast<double>(now.tv_nsec - start.tv_nsec);
}

/// Only what a handler may do: count. Schedulers send TERM two or three times within 0.3 s, and a
/// terminal that closes sends HUP beside; none of them may cost the checkpoint. Somebody at the
/// keyboard who asks again after a second means it.
void on_signal(int signal) {
    ++requests;
    if (signal != SIGINT) return;
    if (!interrupted) {
        clock_gettime(CLOCK_MONOTONIC, &first_interrupt);
        interrupted = true;
    } else if (seconds_since(first_interrupt) >= 1.0) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

/// As `nohup` leaves HUP.
bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void catch_stop_signals() {
    // All whose default ends a process, but those of a crash and QUIT, which asks for one.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGALRM, SIGVTALRM,
                             SIGPROF, SIGPWR}) {
        if (signal == SIGHUP && is_ignored(signal)) continue;
        struct sigaction action {};
        action.sa_handler = on_signal;
        sigemptyset(&action.sa_mask);
        action.sa_flags = SA_RESTART;  // a write under way is finished, not cut
        sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested() { return requests.load(std::memory_order_relaxed) > 0; }

void request_stop() { ++requests; }

void clear_stop_request() {
    requests = 0;
    interrupted = false;
}

}  // namespace tt
