#pragma once

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include <unistd.h>

#include "exchange/periodic.hpp"
#include "io/archive.hpp"
#include "io/checksum.hpp"
#include "small_run.hpp"
#include "simulation/run.hpp"
#include "simulation/state_archive.hpp"

namespace tt {

/// A box so small that its checkpoint has few bytes: nothing in it is not worth damaging.
inline Model smallest_model() {
    Model model = small_model();
    model.lattice = Lattice{9, 8, true};
    model.contact.law = Morse{1e-3, 0.77, 2.45, true};
    model.contact.range = 3.0;
    model.contact.repulsion_range = 2.5;
    model.contact.repulsion_strength = 1e-5;
    return model;
}

/// What the program itself writes of two cells in it, without the checksum.
inline std::string sound_checkpoint() {
    const Model model = smallest_model();
    State state;
    add_cell(state.cells, circle({2.8, 3.6}, 1.4, 8));
    add_cell(state.cells, circle({6.6, 4.1}, 1.5, 9));
    state.sites = sites_at_rest(model.lattice, model.precision);
    derive(model, state);
    const auto path = std::filesystem::temp_directory_path() /
                      ("tanktread-checkpoint-" + std::to_string(getpid()));
    ArchiveWriter archive(path);
    save_state(archive, state);
    archive.commit();
    std::string bytes = read_file(path);
    std::filesystem::remove(path);
    return bytes.substr(0, bytes.size() - sizeof(std::uint64_t));
}

/// What any bytes at all must survive as a checkpoint, even under a checksum that is right for
/// them: they are refused, or a run goes on from them until it is found faulty. Tells whether they
/// were taken.
inline bool try_as_checkpoint(std::string_view body) {
    const std::uint64_t sum = checksum(body);
    std::string bytes(body);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    const Model model = smallest_model();
    Periodic exchange;
    try {
        State state = load_state(ArchiveReader(std::move(bytes), "checkpoint"), model, exchange);
        state_hash(state);
        Health health(HealthLimits{}, state);
        health.examine(model, state);
        constexpr std::int64_t farthest = 1'000'000'000'000;  // beyond the end of any run
        if (state.step < farthest)
            run_steps(model, state, exchange, health, state.step + 3, Clock::time_point::max());
        return true;
    } catch (const DamagedArchive&) {
        return false;
    } catch (const SimulationError&) {
        return true;
    }
}

}  // namespace tt
