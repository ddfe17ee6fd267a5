#include <csignal>

#include <fcntl.h>
#include <unistd.h>

#include "app/command_line.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

/// Memory that a look or a frame has given back is kept for the next. With pages from the system
/// anew each time, a frame takes half as long again.
void keep_memory() {
#if defined(__GLIBC__)
    constexpr int megabyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
    mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
#endif
}

/// A standard stream that is closed would give its number to the next file that is opened, and
/// messages would land in results. A reader that goes away is an error of writing, not a signal.
void guard_streams() {
    for (int stream = 0; stream <= 2; ++stream) {
        if (fcntl(stream, F_GETFD) == -1) ::open("/dev/null", stream == 0 ? O_RDONLY : O_WRONLY);
    }
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
    guard_streams();
    keep_memory();
    return tt::run_command_line(argc, argv);
}
