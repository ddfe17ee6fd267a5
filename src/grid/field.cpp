#include "grid/field.hpp"

#include "base/isa.hpp"

namespace tt {
namespace {

template <class Real>
TT_CLONES double sum_of(const Real* values, int count) {
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

template <class Real>
double sum_of_row(const Field<Real>& field, int j) {
    return sum_of(field.row(j), field.lattice().nx);
}

template <class Real>
double sum_over_sites(const Field<Real>& field) {
    double sum = 0.0;
    for (int j = 0; j < field.lattice().ny; ++j) sum += sum_of_row(field, j);
    return sum;
}

template double sum_of_row(const Field<double>&, int);
template double sum_of_row(const Field<float>&, int);
template double sum_over_sites(const Field<double>&);
template double sum_over_sites(const Field<float>&);

}  // namespace tt
