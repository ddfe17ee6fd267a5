#pragma once

#include "base/parallel.hpp"
#include "fluid/populations.hpp"
#include "grid/field.hpp"

namespace tt {

/// Brings halos in line with the sites they stand for. `fill` copies sites into halos, `fold`
/// returns to the sites what a pass left in the halos. The one place that knows about periodicity,
/// and later about ranks. Team functions.
///
/// Populations use a halo one site deep, vector fields all of Lattice::halo. Beyond a wall there is
/// nothing to stand for: `fill` leaves those rows alone (they stay zero), `fold` clears what a
/// kernel spread there. Of vector fields each thread has the rows that are its own in all passes;
/// where that is not enough they wait by themselves.
class Exchange {
public:
    virtual ~Exchange() = default;
    /// Copies what the coming odd pass reads.
    virtual void fill(Populations<double>& populations) = 0;
    virtual void fill(Populations<float>& populations) = 0;
    /// Moves what the odd pass left.
    virtual void fold(Populations<double>& populations) = 0;
    virtual void fold(Populations<float>& populations) = 0;
    /// Copies.
    virtual void fill(VectorField<double>& field) = 0;
    virtual void fill(VectorField<float>& field) = 0;
    /// Adds to the sites and clears the halo.
    virtual void fold(VectorField<double>& field) = 0;
    virtual void fold(VectorField<float>& field) = 0;
};

/// Ends a pass of `collide_and_stream`: walls and ports answered, halo in line, phase flipped, so
/// that between steps every population can be read and the next pass can start. `answer` says
/// whether there was anything to be done. Team function; waits until all rows have been passed, and
/// is done when all threads have returned.
template <class Real, class Answer>
void settle(Exchange& exchange, Populations<Real>& populations, Answer&& answer) {
    const Phase done = populations.phase;
    team_barrier();  // all rows have been passed
    if (done == Phase::even) {
        if (answer()) team_barrier();
        exchange.fill(populations);
    } else {
        exchange.fold(populations);
        answer();
    }
    if (team_rank() == 0) populations.phase = done == Phase::even ? Phase::odd : Phase::even;
}
template <class Real>
void settle(Exchange& exchange, Populations<Real>& populations) {
    settle(exchange, populations, [] { return false; });
}

}  // namespace tt
