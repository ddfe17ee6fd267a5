#pragma once

#include "exchange/exchange.hpp"

namespace tt {

/// The whole box in one process: x wraps around, y as well where the lattice has no walls.
class Periodic : public Exchange {
public:
    void fill(Populations<double>& populations) override;
    void fill(Populations<float>& populations) override;
    void fold(Populations<double>& populations) override;
    void fold(Populations<float>& populations) override;
    void fill(VectorField<double>& field) override;
    void fill(VectorField<float>& field) override;
    void fold(VectorField<double>& field) override;
    void fold(VectorField<float>& field) override;
};

}  // namespace tt
