#pragma once

#include <vector>

#include "membrane/suspension.hpp"

namespace tt {

/// The rectangle of sites that one cell can touch, and the fraction of each that is cytoplasm of
/// this cell. Columns and rows are unwrapped like the nodes; only who adds a patch to a field wraps
/// them into the box.
struct Patch {
    static constexpr int lanes =
        8;  ///< width is a multiple of this, so that loops over a row have no remainder

    int i = 0, j = 0;           ///< first site
    int width = 0, height = 0;  ///< 0 × 0: nothing
    std::vector<double> value;
    std::vector<double> work;  ///< same layout, for the method that fills the patch

    double* row(int r) { return value.data() + static_cast<std::size_t>(r) * width; }
    const double* row(int r) const { return value.data() + static_cast<std::size_t>(r) * width; }
    bool same_place(const Patch& o) const {
        return i == o.i && j == o.j && width == o.width && height == o.height;
    }
};

/// An outline as seen from its patch: closed (the first node again at the end), the corner of site
/// (patch.i, patch.j) at the origin, so that the local site (c, r) stands at (c + ½, r + ½) and
/// fills the square [c, c+1] × [r, r+1].
struct LocalOutline {
    std::vector<double> x, y;
    int segments() const { return static_cast<int>(x.size()) - 1; }
};

/// Fractions are multiples of this. Sums of a few of them are then exact in a double, whatever
/// their order, so that patches can be taken off a field and put back without leaving a trace.
inline constexpr double fraction_quantum = 0x1p-40;

/// `fraction` rounded to a multiple of the quantum (|fraction| < 2¹¹). Adding and
/// subtracting 1.5·2⁵²·quantum leaves no bits below it; the compiler must not reassociate, which
/// the project's flags see to.
inline double quantised(double fraction) {
    constexpr double shift = 0x1.8p52 * fraction_quantum;
    return (fraction + shift) - shift;
}

/// Sets the rectangle that holds every site within `reach` of the outline, all values 0, and the
/// outline seen from there. The rectangle depends on the outline alone, so that equal outlines give
/// equal bits. False, and nothing changed, if a position is not finite or the cell is `limit` sites
/// long or more (the run is being lost; the guards say so).
bool lay_patch(const Outline& outline, double reach, double limit, Patch& patch,
               LocalOutline& local);

/// Adds to each value those of the rows below it: what changes across an outline becomes what is
/// inside.
void sum_along_y(Patch& patch);

}  // namespace tt
