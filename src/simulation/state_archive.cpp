#include "simulation/state_archive.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "simulation/derive.hpp"
#include "simulation/feed_archive.hpp"
#include "simulation/ports_archive.hpp"
#include "simulation/sections_archive.hpp"
#include "simulation/sound_state.hpp"
#include "simulation/state_arrays.hpp"

namespace tt {
namespace {

template <class S, class Visit>
void for_each_number(S& state, Visit&& visit) {
    visit("step", state.step);
    visit("drive.body_force", state.drive.body_force);
    visit("drive.integral", state.drive.integral);
    visit("contact.repulsion_count", state.contact.repulsion_count);
    visit("contact.smallest_gap", state.contact.smallest_gap);
}

std::string name_of_feed(std::size_t n) { return fmt::format("feed{}.", n); }
std::string plane_name(int i) { return fmt::format("populations.{}", i); }

/// One plane of populations without its halo, row after row. A float is a double too: no bit is
/// lost.
template <class Real>
std::vector<double> plane_of(const Populations<Real>& populations, int i) {
    const Lattice& lattice = populations.lattice();
    std::vector<double> plane;
    plane.reserve(static_cast<std::size_t>(lattice.nx) * lattice.ny);
    for (int j = 0; j < lattice.ny; ++j) {
        const Real* const row = populations.data() + populations.row(i, j);
        plane.insert(plane.end(), row, row + lattice.nx);
    }
    return plane;
}

template <class Real>
void load_populations(const ArchiveReader& archive, Exchange& exchange, const std::string& prefix,
                      Populations<Real>& populations) {
    const Lattice& lattice = populations.lattice();
    const auto odd = archive.value<std::int64_t>(prefix + "populations.odd") != 0;
    populations.phase = odd ? Phase::odd : Phase::even;
    const auto nx = static_cast<std::size_t>(lattice.nx);
    for (int i = 0; i < d2q9::count; ++i) {
        const auto plane = archive.take<double>(prefix + plane_name(i));
        if (plane.size() != nx * lattice.ny) refuse_checkpoint("it is of another lattice");
        for (int j = 0; j < lattice.ny; ++j) {
            const double* const from = plane.data() + nx * j;
            std::transform(from, from + nx, populations.data() + populations.row(i, j),
                           [](double f) { return static_cast<Real>(f); });
        }
    }
    if (odd) exchange.fill(populations);  // as `settle` left it
}

}  // namespace

void copy_saved(const State& from, State& to) {
    to.step = from.step;
    std::visit(
        [&]<class Real>(const Sites<Real>& sites) {
            if (!std::holds_alternative<Sites<Real>>(to.sites)) to.sites = Sites<Real>();
            std::get<Sites<Real>>(to.sites).populations = sites.populations;
        },
        from.sites);
    to.cells = from.cells;
    to.drive = from.drive;
    to.contact.repulsion_count = from.contact.repulsion_count;
    to.contact.smallest_gap = from.contact.smallest_gap;
    to.ports = from.ports;
    to.departed = from.departed;
    to.feeds.resize(from.feeds.size());
    for (std::size_t n = 0; n < from.feeds.size(); ++n) {
        copy_saved(from.feeds[n].state, to.feeds[n].state);
        to.feeds[n].turn = from.feeds[n].turn;
        to.feeds[n].followers = from.feeds[n].followers;
        to.feeds[n].entered = from.feeds[n].entered;
    }
    to.sections = from.sections;
    to.interior.x = from.interior.x;
    to.interior.y = from.interior.y;
}

void save_state(ArchiveOutput& archive, const State& state, const std::string& prefix) {
    for_each_number(state,
                    [&](const char* name, auto value) { archive.put_value(prefix + name, value); });
    for_each_array(
        state, [&](const char* name, const auto& values) { archive.put(prefix + name, values); });
    archive.put(prefix + "kind", state.cells.kind);  // no part of the hash: alike kinds act alike
    for (const CarriedLoad& load : carried_loads)
        archive.put(prefix + load.name, state.cells.*load.values);
    if (prefix.empty()) {  // the channel of a feed has none of these
        save_ports(archive, state);
        save_sections(archive, state);
    }
    std::visit(
        [&](const auto& sites) {
            const auto& populations = sites.populations;
            archive.put_value<std::int64_t>(prefix + "populations.odd",
                                            populations.phase == Phase::odd);
            for (int i = 0; i < d2q9::count; ++i)
                archive.put(prefix + plane_name(i), plane_of(populations, i));
        },
        state.sites);
    for (std::size_t n = 0; n < state.feeds.size(); ++n) {
        save_state(archive, state.feeds[n].state, name_of_feed(n));
        save_led(archive, state.feeds[n], name_of_feed(n));
    }
}

State load_state(const ArchiveReader& archive, const Model& model, Exchange& exchange,
                 const std::string& prefix) {
    State state;
    for_each_number(state, [&](const char* name, auto& value) {
        value = archive.value<std::remove_cvref_t<decltype(value)>>(prefix + name);
    });
    for_each_array(state, [&](const char* name, auto& values) {
        values =
            archive.take<typename std::remove_cvref_t<decltype(values)>::value_type>(prefix + name);
    });
    state.cells.kind = archive.take<std::int32_t>(prefix + "kind");
    for (const CarriedLoad& load : carried_loads)
        state.cells.*load.values = archive.take<double>(prefix + load.name);
    expect_sound(model, state);
    number_cells(state.cells);
    if (prefix.empty()) {
        load_ports(archive, model, state);
        load_sections(archive, model, state);
    }
    size_derived(state.cells);
    state.sites = sites_at_rest(model.lattice, model.precision);
    std::visit([&](auto& sites) { load_populations(archive, exchange, prefix, sites.populations); },
               state.sites);
    for (std::size_t n = 0; n < model.feeds.size(); ++n) {
        FeedState& feed = state.feeds.emplace_back();
        feed.state = load_state(archive, *model.feeds[n].channel, exchange, name_of_feed(n));
        load_led(archive, name_of_feed(n), feed, state);
    }
    derive_kept(model, state);
    return state;
}

std::uint64_t state_hash(const State& state) {
    Checksum sum;
    for_each_number(state, [&](const char*, const auto& value) { sum.add(&value, sizeof value); });
    for_each_array(state, [&](const char*, const auto& values) {
        sum.add(values.data(), values.size() * sizeof values[0]);
    });
    for (const CarriedLoad& load : carried_loads) {  // counts where there is any
        const auto& values = state.cells.*load.values;
        if (std::any_of(values.begin(), values.end(), [](double v) { return v != 0.0; }))
            sum.add(values.data(), values.size() * sizeof values[0]);
    }
    hash_ports(state, sum);
    hash_sections(state, sum);
    std::visit(
        [&](const auto& sites) {
            for (int i = 0; i < d2q9::count; ++i) {
                const std::vector<double> plane = plane_of(sites.populations, i);
                sum.add(plane.data(), plane.size() * sizeof(double));
            }
        },
        state.sites);
    for (const FeedState& feed : state.feeds) {
        const std::uint64_t channel = state_hash(feed.state);
        sum.add(&channel, sizeof channel);
        hash_led(feed, sum);
    }
    return sum.value();
}

}  // namespace tt
