#pragma once

#include <algorithm>
#include <atomic>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace tt {

/// Passes of a step are *team functions*: every thread of one team calls them together and each
/// works on its own contiguous share, of cells or of rows of sites. A pass that needs what others
/// have made waits for it first (`team_barrier`); none waits at its end, unless it says so. Called
/// outside a team they run on one thread and give the same bits: no sum crosses the border of a
/// share.
class Team {
public:
    explicit Team(int size) : size_(size) {}

    int size() const { return size_; }

    /// Waits for all. A step has six of these and takes a few tenths of a millisecond, so it
    /// spins; but where the machine is busy with other work it soon goes to sleep, or a thread
    /// that waits would keep the one it waits for from running. (To yield instead is not enough:
    /// the scheduler may give the time to the other work, a slice of milliseconds at every
    /// barrier.)
    void wait() {
        const unsigned generation = generation_.load(std::memory_order_acquire);
        if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == size_) {
            arrived_.store(0, std::memory_order_relaxed);
            // Sequentially consistent, not just released: notify_all of libstdc++ first looks
            // whether anyone sleeps. Were the store still on its way then, a thread about to sleep
            // could be missed, find the old generation, and sleep for ever.
            generation_.store(generation + 1, std::memory_order_seq_cst);
            generation_.notify_all();
            return;
        }
        for (int looks = 0; generation_.load(std::memory_order_acquire) == generation; ++looks) {
            if (looks > patience) generation_.wait(generation, std::memory_order_acquire);
        }
    }

    /// The team that the calling thread works in, and its number there.
    struct Membership {
        Team* team = nullptr;
        int rank = 0;
    };
    static Membership& mine() {
        thread_local Membership membership;
        return membership;
    }

private:
    static constexpr int patience =
        300'000;  ///< looks before sleep: about a tenth of a millisecond

    int size_;
    alignas(64) std::atomic<int> arrived_{0};
    alignas(64) std::atomic<unsigned> generation_{0};
};

inline int team_size() { return Team::mine().team ? Team::mine().team->size() : 1; }
inline int team_rank() { return Team::mine().rank; }
inline void team_barrier() {
    if (team_size() > 1) Team::mine().team->wait();
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

/// Says once that the system has not given as many threads as were asked for.
void tell_fewer_threads(int started, int asked);

/// Runs `f` on every thread of a new team of `threads`, the calling one among them. `f` must not
/// throw. Where the system gives no more threads (limits of processes or of memory) the team is of
/// those that there are: results do not depend on how many.
template <class F>
void with_team(int threads, F&& f) {
    if (threads <= 1) {
        f();
        return;
    }
    std::optional<Team> team;
    std::atomic<Team*> complete{nullptr};  // once all are there that come
    const auto work = [&](int rank) {
        complete.wait(nullptr, std::memory_order_acquire);
        Team::mine() = {complete.load(std::memory_order_acquire), rank};
        f();
        Team::mine() = {};
    };
    std::vector<std::jthread> others;
    others.reserve(static_cast<std::size_t>(threads) - 1);
    try {
        for (int rank = 1; rank < threads; ++rank) others.emplace_back(work, rank);
    } catch (const std::system_error&) {
        tell_fewer_threads(static_cast<int>(others.size()) + 1, threads);
    }
    team.emplace(static_cast<int>(others.size()) + 1);
    complete.store(&*team, std::memory_order_seq_cst);
    complete.notify_all();
    work(0);
}

}  // namespace tt
