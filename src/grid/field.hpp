#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "grid/lattice.hpp"

namespace tt {

/// std::vector storage that starts on a cache line.
template <class T>
struct CacheAligned {
    using value_type = T;
    CacheAligned() = default;
    template <class U>
    CacheAligned(const CacheAligned<U>&) {}
    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64}));
    }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
    friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }
};

/// Of all that the sites hold. In fp32 rounding of the populations is relative to the deviation
/// from rest; membranes and their nodes stay in double.
enum class Precision : std::uint8_t { fp64, fp32 };

/// One number per site, halo included, row after row. `Real` is double or float: what the sites
/// hold is all in the one or all in the other. Sums over sites are in double either way.
template <class Real = double>
class Field {
public:
    Field() = default;
    explicit Field(const Lattice& lattice, Real value = 0)
        : lattice_(lattice), values_(lattice.size(), value) {}

    const Lattice& lattice() const { return lattice_; }
    Real& operator()(int i, int j) { return values_[lattice_.index(i, j)]; }
    Real operator()(int i, int j) const { return values_[lattice_.index(i, j)]; }
    /// Pointer to site (0, j); row(j)[i] is site (i, j), halo included.
    Real* row(int j) { return values_.data() + lattice_.index(0, j); }
    const Real* row(int j) const { return values_.data() + lattice_.index(0, j); }
    Real* data() { return values_.data(); }
    const Real* data() const { return values_.data(); }
    std::size_t size() const { return values_.size(); }
    void fill(Real value) { values_.assign(values_.size(), value); }

private:
    Lattice lattice_;
    std::vector<Real, CacheAligned<Real>> values_;
};

/// Sum over the sites of row j, over all sites. In a fixed order, eight sites of a row side by
/// side.
template <class Real>
double sum_of_row(const Field<Real>& field, int j);
template <class Real>
double sum_over_sites(const Field<Real>& field);

/// A vector per site, as two fields.
template <class Real = double>
struct VectorField {
    Field<Real> x;
    Field<Real> y;

    VectorField() = default;
    explicit VectorField(const Lattice& lattice) : x(lattice), y(lattice) {}
    Vec2 operator()(int i, int j) const { return {x(i, j), y(i, j)}; }
};

}  // namespace tt
