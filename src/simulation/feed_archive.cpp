#include "simulation/feed_archive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "simulation/sound_state.hpp"

namespace tt {
namespace {

[[noreturn]] void refuse() { refuse_checkpoint("its list of cells that come in is wrong"); }

constexpr std::array follower_numbers{std::pair{"followers.cell", &Follower::cell},
                                      std::pair{"followers.leader", &Follower::leader},
                                      std::pair{"followers.turn", &Follower::turn}};
constexpr std::array entered_numbers{std::pair{"entered.time", &Entered::time},
                                     std::pair{"entered.place", &Entered::place},
                                     std::pair{"entered.area", &Entered::area}};

template <class Item, class T>
std::vector<T> numbers_of(const std::vector<Item>& items, T Item::*member) {
    std::vector<T> numbers;
    for (const Item& item : items) numbers.push_back(item.*member);
    return numbers;
}

template <class Item, class T>
void set_numbers(const std::vector<T>& numbers, T Item::*member, std::vector<Item>& items) {
    if (items.empty()) items.resize(numbers.size());
    if (items.size() != numbers.size()) refuse();
    for (std::size_t k = 0; k < items.size(); ++k) items[k].*member = numbers[k];
}

/// Marks the cells that are led. Each leads one that is there, and is there itself.
void mark_led(const FeedState& feed, State& state) {
    const std::int32_t leaders = feed.state.cells.cell_count();
    if (feed.turn.size() > static_cast<std::size_t>(leaders)) refuse();
    for (const Follower& follower : feed.followers) {
        const auto& id = state.cells.id;
        const auto at = std::find(id.begin(), id.end(), follower.cell);
        if (at == id.end() || follower.leader < 0 || follower.leader >= leaders) refuse();
        const auto cell = static_cast<int>(at - id.begin());
        std::uint8_t& led = state.cells.led[static_cast<std::size_t>(cell)];
        if (led != 0 ||
            state.cells.node_count(cell) != feed.state.cells.node_count(follower.leader))
            refuse();
        led = 1;
    }
    for (const Entered& entered : feed.entered)
        for (const auto& [name, member] : entered_numbers)
            if (!std::isfinite(entered.*member)) refuse();
}

}  // namespace

void save_led(ArchiveOutput& archive, const FeedState& feed, const std::string& prefix) {
    archive.put(prefix + "turn", feed.turn);
    for (const auto& [name, member] : follower_numbers)
        archive.put(prefix + name, numbers_of(feed.followers, member));
    archive.put(prefix + "entered.id", numbers_of(feed.entered, &Entered::id));
    archive.put(prefix + "entered.kind", numbers_of(feed.entered, &Entered::kind));
    for (const auto& [name, member] : entered_numbers)
        archive.put(prefix + name, numbers_of(feed.entered, member));
}

void load_led(const ArchiveReader& archive, const std::string& prefix, FeedState& feed,
              State& state) {
    feed.turn = archive.take<std::int32_t>(prefix + "turn");
    for (const auto& [name, member] : follower_numbers)
        set_numbers(archive.take<std::int32_t>(prefix + name), member, feed.followers);
    set_numbers(archive.take<std::int64_t>(prefix + "entered.id"), &Entered::id, feed.entered);
    set_numbers(archive.take<std::int64_t>(prefix + "entered.kind"), &Entered::kind, feed.entered);
    for (const auto& [name, member] : entered_numbers)
        set_numbers(archive.take<double>(prefix + name), member, feed.entered);
    mark_led(feed, state);
}

void hash_led(const FeedState& feed, Checksum& sum) {
    sum.add(feed.turn.data(), feed.turn.size() * sizeof feed.turn[0]);
    for (const Follower& follower : feed.followers)
        for (const auto& [name, member] : follower_numbers)
            sum.add(&(follower.*member), sizeof(std::int32_t));
    for (const Entered& entered : feed.entered) {
        sum.add(&entered.id, sizeof entered.id);
        for (const auto& [name, member] : entered_numbers)
            sum.add(&(entered.*member), sizeof(double));
    }
}

}  // namespace tt
