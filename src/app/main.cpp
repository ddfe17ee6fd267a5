#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "app/command_line.hpp"

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

}  // namespace

int main(int argc, char** argv) {
    keep_memory();
    return tt::run_command_line(argc, argv);
}
