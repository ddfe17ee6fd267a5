#pragma once

#include <utility>

#include "coupling/patch.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/relaxation.hpp"
#include "grid/field.hpp"

namespace tt {

/// Sets the relaxation rates of all sites from their fractions of cytoplasm.
template <class Real>
void set_all_rates(const ViscosityModel& model, Field<>& fraction, Relaxation<Real>& relaxation);

/// Takes patch `before` off the fractions of the rows [rows.first, rows.second) of the box, adds
/// `now`, and sets the rates of the sites whose fraction that changes.
template <class Real>
void change_patch(const ViscosityModel& model, const Patch& now, const Patch& before,
                  std::pair<int, int> rows, Field<>& fraction, Relaxation<Real>& relaxation);

}  // namespace tt
