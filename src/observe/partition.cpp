#include "observe/partition.hpp"

#include <cmath>

namespace tt {

PriesLaw::PriesLaw(Length feeding, Length daughter, Length other, double discharge_hematocrit) {
    const double scale = (1.0 - discharge_hematocrit) / (1e6 * feeding.si);
    const double own = daughter.si * daughter.si, its = other.si * other.si;
    X0 = 0.964 * scale;
    B = 1.0 + 6.98 * scale;
    A = -13.29 * (own - its) / (own + its) * scale;
}

double PriesLaw::cell_fraction(double flow_fraction) const {
    const double x = (flow_fraction - X0) / (1.0 - 2.0 * X0);
    if (!(x > 0.0)) return std::isnan(x) ? x : 0.0;
    if (x >= 1.0) return 1.0;
    return 1.0 / (1.0 + std::exp(-A) * std::pow((1.0 - x) / x, B));
}

}  // namespace tt
