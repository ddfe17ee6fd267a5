#pragma once

#include "exchange/exchange.hpp"

namespace tt {

/// The whole box in one process: x wraps around, y as well where the lattice has no walls.
class Periodic : public Exchange {
public:
    void fill(Populations& populations) override;
    void fold(Populations& populations) override;
    void fill(VectorField& field) override;
    void fold(VectorField& field) override;
};

}  // namespace tt
