#pragma once

#include "fluid/populations.hpp"
#include "grid/field.hpp"

namespace tt {

/// Brings halos in line with the sites they stand for. `fill` copies sites into halos, `fold` returns to the sites what
/// a pass left in the halos. The one place that knows about periodicity, and later about ranks. Team functions.
class Exchange {
public:
    virtual ~Exchange() = default;
    virtual void fill(Populations& populations) = 0;   ///< phase odd, before the pass
    virtual void fold(Populations& populations) = 0;   ///< phase odd, after the pass: moves
    virtual void fill(VectorField& field) = 0;         ///< copies
    virtual void fold(VectorField& field) = 0;         ///< adds to the sites and clears the halo
};

}  // namespace tt
