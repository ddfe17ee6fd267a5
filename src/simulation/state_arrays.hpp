#pragma once

namespace tt {

// The one list of arrays that save, load, hash and checks of a state go by.

/// Calls visit(name, array) for every array but the populations and the carried loads: the one list
/// that save, load and hash go by.
template <class S, class Visit>
void for_each_array(S& state, Visit&& visit) {
    auto& cells = state.cells;
    visit("first", cells.first);
    visit("x", cells.x);
    visit("y", cells.y);
    visit("fx", cells.fx);
    visit("fy", cells.fy);
    visit("pair_fx", cells.pair_fx);
    visit("pair_fy", cells.pair_fy);
    visit("ux", cells.ux);
    visit("uy", cells.uy);
    visit("ux_sampled", cells.ux_sampled);
    visit("uy_sampled", cells.uy_sampled);
    visit("rest_curvature", cells.rest_curvature);
    visit("rest_length", cells.rest_length);
    visit("reference_area", cells.reference_area);
    visit("reference_perimeter", cells.reference_perimeter);
    visit("alpha", cells.alpha);
    visit("area", cells.area);
    visit("perimeter", cells.perimeter);
    visit("interior.x", state.interior.x);
    visit("interior.y", state.interior.y);
}

}  // namespace tt
