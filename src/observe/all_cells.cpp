#include "observe/all_cells.hpp"

#include "base/undefined.hpp"

namespace tt {

AllCells all_cells(const State& state) {
    const Suspension& cells = state.cells;
    if (state.departed.empty()) return {cells.first, cells.rest_length, cells.kind};
    std::vector<std::vector<double>> lengths(cells.id.size() + state.departed.size());
    AllCells all;
    all.kind.resize(lengths.size());
    for (const Departed& d : state.departed) {
        lengths[static_cast<std::size_t>(d.id)] = d.rest_length;
        all.kind[static_cast<std::size_t>(d.id)] = static_cast<std::int32_t>(d.kind);
    }
    for (int c = 0; c < cells.cell_count(); ++c) {
        const auto id = static_cast<std::size_t>(cells.id[c]);
        lengths[id].assign(cells.rest_length.begin() + cells.first[c],
                           cells.rest_length.begin() + cells.first[c + 1]);
        all.kind[id] = cells.kind[c];
    }
    for (const std::vector<double>& cell : lengths) {
        all.rest_length.insert(all.rest_length.end(), cell.begin(), cell.end());
        all.first.push_back(static_cast<std::int32_t>(all.rest_length.size()));
    }
    return all;
}

std::vector<double> per_node_of_all(const AllCells& all, const Suspension& cells,
                                    const std::vector<double>& x, const std::vector<double>& y,
                                    double unit) {
    std::vector<double> pairs(2 * static_cast<std::size_t>(all.first.back()), undefined);
    for (int c = 0; c < cells.cell_count(); ++c) {
        auto to = pairs.begin() + 2 * all.first[static_cast<std::size_t>(cells.id[c])];
        for (int n = cells.first[c]; n < cells.first[c + 1]; ++n) {
            *to++ = x[n] * unit;
            *to++ = y[n] * unit;
        }
    }
    return pairs;
}

}  // namespace tt
