#include "base/parallel.hpp"

#include "base/tell.hpp"

namespace tt {

void tell_fewer_threads(int started, int asked) {
    static std::atomic<bool> told{false};
    if (!told.exchange(true))
        tell_user("tanktread: the system gives {} of {} threads; results are the same\n", started,
                  asked);
}

}  // namespace tt
