#pragma once

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

/// One number per site, halo included, row after row.
class Field {
public:
    Field() = default;
    explicit Field(const Lattice& lattice, double value = 0.0)
        : lattice_(lattice), values_(lattice.size(), value) {}

    const Lattice& lattice() const { return lattice_; }
    double& operator()(int i, int j) { return values_[lattice_.index(i, j)]; }
    double operator()(int i, int j) const { return values_[lattice_.index(i, j)]; }
    /// Pointer to site (0, j); row(j)[i] is site (i, j), halo included.
    double* row(int j) { return values_.data() + lattice_.index(0, j); }
    const double* row(int j) const { return values_.data() + lattice_.index(0, j); }
    double* data() { return values_.data(); }
    const double* data() const { return values_.data(); }
    std::size_t size() const { return values_.size(); }
    void fill(double value) { values_.assign(values_.size(), value); }

private:
    Lattice lattice_;
    std::vector<double, CacheAligned<double>> values_;
};

/// Sum over the sites of row j, over all sites. In a fixed order, eight sites of a row side by
/// side.
double sum_of_row(const Field& field, int j);
double sum_over_sites(const Field& field);

/// A vector per site, as two fields.
struct VectorField {
    Field x;
    Field y;

    VectorField() = default;
    explicit VectorField(const Lattice& lattice) : x(lattice), y(lattice) {}
    Vec2 operator()(int i, int j) const { return {x(i, j), y(i, j)}; }
};

}  // namespace tt
