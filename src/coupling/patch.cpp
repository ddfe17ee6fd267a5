#include "coupling/patch.hpp"

#include <algorithm>
#include <cmath>

#include "base/isa.hpp"
#include "base/lesser.hpp"

namespace tt {
namespace {

struct Extent {
    double low = 0.0, high = 0.0;
    bool finite = true;
};

TT_CLONES Extent extent(const double* v, int count) {
    double low = v[0], high = v[0];
    double nought = 0.0;  // stays 0 unless a value is NaN or infinite
#pragma omp simd reduction(min : low) reduction(max : high) reduction(+ : nought)
    for (int k = 0; k < count; ++k) {
        low = lesser(low, v[k]);
        high = greater(high, v[k]);
        nought += v[k] * 0.0;
    }
    return {low, high, nought == 0.0};
}

void copy_closed(std::span<const double> from, double origin, std::vector<double>& to) {
    const std::size_t n = from.size();
    to.resize(n + 1);
    for (std::size_t k = 0; k < n; ++k) to[k] = from[k] - origin;
    to[n] = to[0];
}

}  // namespace

bool lay_patch(const Outline& outline, double reach, double limit, Patch& patch,
               LocalOutline& local) {
    const Extent ex = extent(outline.x.data(), outline.size());
    const Extent ey = extent(outline.y.data(), outline.size());
    if (!ex.finite || !ey.finite || !(ex.high - ex.low < limit) || !(ey.high - ey.low < limit))
        return false;
    if (!(std::abs(ex.low) < 1e9) || !(std::abs(ey.low) < 1e9)) return false;
    patch.i = static_cast<int>(std::floor(ex.low - reach)) - 1;
    patch.j = static_cast<int>(std::floor(ey.low - reach)) - 1;
    const int width = static_cast<int>(std::ceil(ex.high + reach)) + 1 - patch.i;
    patch.width = (width + Patch::lanes - 1) / Patch::lanes * Patch::lanes;
    patch.height = static_cast<int>(std::ceil(ey.high + reach)) + 2 - patch.j;
    const std::size_t sites = static_cast<std::size_t>(patch.width) * patch.height;
    if (patch.value.capacity() < sites) patch.value.reserve(2 * sites);  // room for a cell to turn
    if (patch.work.capacity() < sites) patch.work.reserve(2 * sites);
    patch.value.assign(sites, 0.0);
    copy_closed(outline.x, patch.i, local.x);
    copy_closed(outline.y, patch.j, local.y);
    return true;
}

TT_CLONES void sum_along_y(Patch& patch) {
    for (int r = 1; r < patch.height; ++r) {
        const double* below = patch.row(r - 1);
        double* here = patch.row(r);
        for (int c = 0; c < patch.width; ++c) here[c] += below[c];
    }
}

}  // namespace tt
