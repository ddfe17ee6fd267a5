#include "simulation/ports_archive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "simulation/sound_state.hpp"

namespace tt {
namespace {

/// Two densities and two inflows each.
std::vector<double> array_of(const std::vector<PortFlow>& ports) {
    std::vector<double> numbers;
    for (const PortFlow& port : ports)
        for (const auto& pair : {port.density, port.inflow})
            numbers.insert(numbers.end(), pair.begin(), pair.end());
    return numbers;
}

/// The numbers of a cell that left, but for whole ones.
constexpr std::array departed_numbers{
    std::pair{"departed.time", &Departed::time}, std::pair{"departed.place", &Departed::place},
    std::pair{"departed.lambda_C", &Departed::lambda_C},
    std::pair{"departed.speed", &Departed::speed}, std::pair{"departed.area", &Departed::area}};

void save_departed(ArchiveOutput& archive, const std::vector<Departed>& departed) {
    std::vector<std::int64_t> id, exit, kind, nodes;
    std::vector<double> rest_length;
    for (const Departed& d : departed) {
        id.push_back(d.id);
        exit.push_back(d.exit);
        kind.push_back(d.kind);
        nodes.push_back(static_cast<std::int64_t>(d.rest_length.size()));
        rest_length.insert(rest_length.end(), d.rest_length.begin(), d.rest_length.end());
    }
    archive.put("departed.id", id);
    archive.put("departed.exit", exit);
    archive.put("departed.kind", kind);
    archive.put("departed.nodes", nodes);
    archive.put("departed.rest_length", rest_length);
    for (const auto& [name, member] : departed_numbers) {
        std::vector<double> numbers;
        for (const Departed& d : departed) numbers.push_back(d.*member);
        archive.put(name, numbers);
    }
}

std::vector<Departed> load_departed(const ArchiveReader& archive, std::size_t exits,
                                    std::size_t kinds) {
    const auto id = archive.take<std::int64_t>("departed.id");
    const auto exit = archive.take<std::int64_t>("departed.exit");
    const auto kind = archive.take<std::int64_t>("departed.kind");
    const auto nodes = archive.take<std::int64_t>("departed.nodes");
    const auto rest_length = archive.take<double>("departed.rest_length");
    if (exit.size() != id.size() || kind.size() != id.size() || nodes.size() != id.size())
        refuse_checkpoint("its list of cells that left is wrong");
    std::vector<Departed> departed(id.size());
    auto length = rest_length.begin();
    for (std::size_t k = 0; k < id.size(); ++k) {
        if (exit[k] < 0 || exit[k] >= static_cast<std::int64_t>(exits) || kind[k] < 0 ||
            kind[k] >= static_cast<std::int64_t>(kinds) || nodes[k] < 0 ||
            nodes[k] > rest_length.end() - length)
            refuse_checkpoint("its list of cells that left is wrong");
        departed[k].id = id[k];
        departed[k].exit = exit[k];
        departed[k].kind = kind[k];
        departed[k].rest_length.assign(length, length + nodes[k]);
        length += nodes[k];
    }
    for (const auto& [name, member] : departed_numbers) {
        const auto numbers = archive.take<double>(name);
        if (numbers.size() != id.size()) refuse_checkpoint("its list of cells that left is wrong");
        for (std::size_t k = 0; k < id.size(); ++k) {
            if (!std::isfinite(numbers[k]))
                refuse_checkpoint("a cell that left has a number not finite");
            departed[k].*member = numbers[k];
        }
    }
    return departed;
}

/// Each number from 0 on is that of one cell, there or gone.
void expect_numbers(const State& state) {
    std::vector<std::int64_t> numbers(state.cells.id.begin(), state.cells.id.end());
    for (const Departed& d : state.departed) numbers.push_back(d.id);
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (numbers[k] != static_cast<std::int64_t>(k))
            refuse_checkpoint("the numbers of its cells are wrong");
}

}  // namespace

void save_ports(ArchiveOutput& archive, const State& state) {
    if (!state.ports.empty()) archive.put("ports", array_of(state.ports));
    if (state.departed.empty()) return;
    save_departed(archive, state.departed);
    archive.put("id", state.cells.id);
}

void load_ports(const ArchiveReader& archive, const Model& model, State& state) {
    state.ports.resize(model.boundaries.ports.size());
    if (!state.ports.empty()) {
        const auto numbers = archive.take<double>("ports");
        if (numbers.size() != array_of(state.ports).size())
            refuse_checkpoint("it is of other ports");
        const double* from = numbers.data();
        for (PortFlow& port : state.ports)
            for (auto* pair : {&port.density, &port.inflow})
                for (double& number : *pair) number = *from++;
        for (const double number : numbers)
            if (!std::isfinite(number))
                refuse_checkpoint("'ports' holds a number that is not finite");
    }
    if (!archive.has("departed.id")) return;
    std::vector<std::int32_t>& id = state.cells.id;
    state.departed = load_departed(archive, model.exits.size(), model.kinds.size());
    id = archive.take<std::int32_t>("id");
    if (id.size() != static_cast<std::size_t>(state.cells.cell_count()))
        refuse_checkpoint("the numbers of its cells are wrong");
    expect_numbers(state);
}

void hash_ports(const State& state, Checksum& sum) {
    const std::vector<double> ports = array_of(state.ports);
    sum.add(ports.data(), ports.size() * sizeof(double));
    for (const Departed& d : state.departed) {
        for (const std::int64_t number : {d.id, d.exit}) sum.add(&number, sizeof number);
        for (const auto& [name, member] : departed_numbers) sum.add(&(d.*member), sizeof(double));
    }
}

}  // namespace tt
