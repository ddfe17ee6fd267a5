#include "simulation/stop.hpp"

#include <csignal>
#include <initializer_list>

namespace tt {
namespace {

volatile std::sig_atomic_t requests = 0;

/// Only what a handler may do: count, and let the second signal have its default effect.
void on_signal(int signal) {
    requests = requests + 1;
    if (requests > 1) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void catch_stop_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGUSR2}) {
        struct sigaction action {};
        action.sa_handler = on_signal;
        sigemptyset(&action.sa_mask);
        action.sa_flags = SA_RESTART;  // a write under way is finished, not cut
        sigaction(signal, &action, nullptr);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested() { return requests > 0; }

void request_stop() { requests = requests + 1; }

void clear_stop_request() { requests = 0; }

}  // namespace tt
