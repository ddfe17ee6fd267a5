#include "case/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/random.hpp"
#include "base/units.hpp"
#include "case/step_limits.hpp"

namespace tt {
namespace {

/// Whole numbers of this sum, as near to the shares as they can be: first rounded down, then one
/// more where most was cut off.
std::vector<int> apportioned(const std::vector<double>& shares, int total) {
    std::vector<int> numbers;
    std::vector<std::pair<double, std::size_t>> cut_off;
    for (std::size_t n = 0; n < shares.size(); ++n) {
        const double exact = shares[n] * total;
        numbers.push_back(static_cast<int>(std::floor(exact + 1e-9)));
        cut_off.emplace_back(numbers.back() - exact, n);
    }
    std::sort(cut_off.begin(), cut_off.end());
    const int left = total - std::accumulate(numbers.begin(), numbers.end(), 0);
    for (int n = 0; n < left; ++n) ++numbers[cut_off[static_cast<std::size_t>(n)].second];
    return numbers;
}

void expect_some_of_each(const Case& c, const std::vector<int>& numbers) {
    std::vector<Fault> faults;
    const int total = std::accumulate(numbers.begin(), numbers.end(), 0);
    for (std::size_t n = 0; n < numbers.size(); ++n)
        if (numbers[n] == 0)
            faults.push_back(
                {"", 0, 0,
                 fmt::format("[[kind]] '{}' has no cell: share = {:.3g} % of {} cells is less than "
                             "half a cell; write count = 1, a larger share, or more cells",
                             c.kinds[n].name, 100.0 * c.kinds[n].share.value_or(0.0), total)});
    if (!faults.empty()) throw CaseError(std::move(faults));
}

/// A rigid body has none, and plasma within.
void without_membrane(Case& one) {
    one.cells.cytoplasm_viscosity = one.plasma.viscosity;
    one.membrane.hardening.apply_to.clear();
    one.membrane.membrane_viscosity = {};
    one.membrane.bending_viscosity = {};
}

double extreme_radius(const Case& c, bool largest) {
    double result = largest ? 0.0 : HUGE_VAL;
    for (const Case& one : cases_by_kind(c)) {
        const double radius = equivalent_radius(one).si;
        result = largest ? std::max(result, radius) : std::min(result, radius);
    }
    return result;
}

}  // namespace

std::vector<Case> cases_by_kind(const Case& c) {
    std::vector<Case> cases;
    if (c.kinds.empty()) cases.push_back(c);
    for (const KindCase& kind : c.kinds) {
        Case& one = cases.emplace_back(c);
        one.kinds.clear();
        static_cast<CellTypeCase&>(one.cells) = kind;
        one.membrane = kind;
        one.cells.count = kind.count;
        one.cells.hematocrit.reset();
        if (auto* layout = std::get_if<AtPositions>(&one.cells.layout))
            layout->positions = kind.positions;
    }
    for (Case& one : cases)
        if (one.membrane.rigid) without_membrane(one);
    return cases;
}

std::vector<CellTypeCase*> cell_types(Case& c) {
    std::vector<CellTypeCase*> types{&c.cells};
    for (KindCase& kind : c.kinds) types.push_back(&kind);
    return types;
}

Length smallest_cell_radius(const Case& c) { return Length{extreme_radius(c, false)}; }
Length largest_cell_radius(const Case& c) { return Length{extreme_radius(c, true)}; }

double shear_number_at(const Case& one, Rate rate) {
    if (one.membrane.rigid) return 0.0;
    return one.plasma.viscosity.si * std::abs(rate.si) * equivalent_radius(one).si /
           one.membrane.shear_modulus.si;
}

double viscosity_contrast(const Case& c) {
    double largest = 1.0;
    for (const Case& one : cases_by_kind(c)) {
        const double ratio = one.cells.cytoplasm_viscosity.si / c.plasma.viscosity.si;
        largest = std::max({largest, ratio, 1.0 / ratio});
    }
    return largest;
}

std::vector<int> cells_of_kinds(const Case& c, const std::vector<double>& areas, double room,
                                int multiple) {
    // Without [[kind]] one kind has all.
    std::vector<double> shares{1.0};
    int counted = 0;
    double area = areas.front(), counted_area = 0.0;
    if (!c.kinds.empty()) {
        shares.clear();
        area = 0.0;
        for (std::size_t n = 0; n < c.kinds.size(); ++n) {
            const KindCase& kind = c.kinds[n];
            const auto count = static_cast<int>(kind.count.value_or(0));
            counted += count;
            counted_area += count * areas[n];
            shares.push_back(kind.share.value_or(0.0));
            area += shares.back() * areas[n];
        }
    }
    const auto whole = [&](double cells) {  // as near as there are whole multiples
        return multiple * std::max(1, static_cast<int>(std::lround(cells / multiple)));
    };
    int total = counted;
    if (area > 0.0)
        total = c.cells.hematocrit
                    ? whole(counted + (*c.cells.hematocrit * room - counted_area) / area)
                    : static_cast<int>(c.cells.count.value_or(1));
    if (total < counted)
        throw CaseError(
            {{"", 0, 0,
              fmt::format("[[kind]] the cells with a count are {} already, and {} are asked for in "
                          "all; write fewer, or more in [cells]",
                          counted, total)}});
    std::vector<int> numbers = apportioned(shares, total - counted);
    for (std::size_t n = 0; n < c.kinds.size(); ++n)
        numbers[n] += static_cast<int>(c.kinds[n].count.value_or(0));
    if (!c.kinds.empty()) expect_some_of_each(c, numbers);
    return numbers;
}

std::vector<int> mixed(const std::vector<int>& numbers, std::uint64_t seed) {
    std::vector<int> kinds;
    for (std::size_t n = 0; n < numbers.size(); ++n)
        kinds.insert(kinds.end(), static_cast<std::size_t>(numbers[n]), static_cast<int>(n));
    Random random(seed);
    for (std::size_t n = kinds.size(); n > 1; --n) {
        const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
        std::swap(kinds[n - 1], kinds[other]);
    }
    return kinds;
}

}  // namespace tt
