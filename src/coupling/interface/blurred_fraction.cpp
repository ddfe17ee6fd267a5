#include "coupling/interface/blurred_fraction.hpp"

#include <algorithm>

#include "base/isa.hpp"

namespace tt {
namespace {

/// to = ¼ (below + 2 here + above); the rows may not overlap.
TT_CLONES void blur_rows(const double* below, const double* here, const double* above, int count,
                         double* to) {
    for (int c = 0; c < count; ++c) to[c] = 0.25 * (below[c] + above[c]) + 0.5 * here[c];
}

}  // namespace

void BlurredFraction::blur(Patch& patch) {
    // The outermost sites of a patch are always zero, so neither direction needs a border.
    patch.work.assign(patch.value.size(), 0.0);
    const int width = patch.width;
    for (int r = 1; r + 1 < patch.height; ++r)
        blur_rows(patch.row(r - 1), patch.row(r), patch.row(r + 1), width,
                  patch.work.data() + r * width);
    for (int r = 1; r + 1 < patch.height; ++r) {
        const double* row = patch.work.data() + r * width;
        blur_rows(row, row + 1, row + 2, width - 2, patch.row(r) + 1);
    }
}

}  // namespace tt
