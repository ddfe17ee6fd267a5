#pragma once

#include <algorithm>
#include <utility>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace tt {

/// Passes of a step are *team functions*: every thread of one parallel region calls them together, each works
/// on its own contiguous share, and a barrier ends them. Called outside a parallel region they run on one
/// thread and give the same bits: no sum crosses the border of a share.
inline int team_size() {
#ifdef _OPENMP
    return omp_get_num_threads();
#else
    return 1;
#endif
}

inline int team_rank() {
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

inline void team_barrier() {
#ifdef _OPENMP
#pragma omp barrier
#endif
}

/// [begin, end) of this thread's share of 0 … count.
inline std::pair<int, int> team_share(int count) {
    const int size = team_size();
    const int rank = team_rank();
    const int base = count / size;
    const int extra = count % size;
    const int begin = rank * base + std::min(rank, extra);
    return {begin, begin + base + (rank < extra ? 1 : 0)};
}

/// Runs `f()` on one thread of the team; all wait for it.
template <class F>
void on_one_thread(F&& f) {
    if (team_rank() == 0) f();
    team_barrier();
}

/// Runs `f` on every thread of a new team of `threads`.
template <class F>
void with_team(int threads, F&& f) {
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
    f();
#else
    (void)threads;
    f();
#endif
}

}  // namespace tt
