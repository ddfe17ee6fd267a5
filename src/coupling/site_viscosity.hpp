#pragma once

#include <utility>

#include "coupling/patch.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"

namespace tt {

/// Sets the relaxation rates of all sites from the cytoplasm that they hold.
template <class Real>
void set_all_rates(const ViscosityModel& model, Field<>& cytoplasm, Relaxation<Real>& relaxation);

/// Takes patch `before` of a cell of this kind off the rows [rows.first, rows.second) of the box,
/// adds `now`, and sets the rates of the sites that this changes.
template <class Real>
void change_patch(const ViscosityModel& model, int kind, const Patch& now, const Patch& before,
                  std::pair<int, int> rows, Field<>& cytoplasm, Relaxation<Real>& relaxation);

}  // namespace tt
