#include "membrane/stability.hpp"

#include <algorithm>
#include <variant>

namespace tt {
namespace {

constexpr double largest_stretch = 3.0;  // a membrane has burst long before

double tension_of(const Membrane& membrane, double stretch) {
    const double alpha = membrane.hardening.shear ? membrane.hardening(stretch) : 1.0;
    return alpha *
           std::visit([&](const auto& law) { return law.tension(stretch); }, membrane.in_plane);
}

double slope_at(const Membrane& membrane, double stretch) {
    constexpr double step = 1e-5;
    return (tension_of(membrane, stretch + step) - tension_of(membrane, stretch - step)) /
           (2.0 * step);
}

}  // namespace

double stretch_at(const Membrane& membrane, double tension) {
    double low = 1.0, high = largest_stretch;
    if (tension <= tension_of(membrane, low)) return low;
    if (tension >= tension_of(membrane, high)) return high;
    for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (tension_of(membrane, middle) < tension ? low : high) = middle;
    }
    return high;
}

double tension_slope(const Membrane& membrane, double stretch) {
    constexpr int looks = 64;
    double slope = 0.0;
    for (int n = 0; n <= looks; ++n) {
        const double here = 1.0 + (stretch - 1.0) * n / looks;
        slope = std::max({slope, slope_at(membrane, here), tension_of(membrane, here)});
    }
    return slope;
}

double bending_modulus(const Membrane& membrane, double stretch) {
    const double alpha = membrane.hardening.bending ? membrane.hardening(stretch) : 1.0;
    return alpha * std::visit([](const auto& law) { return law.modulus; }, membrane.bending);
}

double area_stiffness(const Membrane& membrane, double stretch) {
    return membrane.area_stiffness * (membrane.hardening.area ? membrane.hardening(stretch) : 1.0);
}

}  // namespace tt
