#include "grid/field.hpp"

#include "base/isa.hpp"

namespace tt {
namespace {

TT_CLONES double sum_of(const double* values, int count) {
    constexpr int lanes = 8;
    double lane[lanes] = {};
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] += values[i + k];
    }
    for (; i < count; ++i) lane[0] += values[i];
    double sum = 0.0;
    for (const double part : lane) sum += part;
    return sum;
}

}  // namespace

double sum_of_row(const Field& field, int j) { return sum_of(field.row(j), field.lattice().nx); }

double sum_over_sites(const Field& field) {
    double sum = 0.0;
    for (int j = 0; j < field.lattice().ny; ++j) sum += sum_of_row(field, j);
    return sum;
}

}  // namespace tt
