#include "fluid/populations.hpp"

namespace tt {
namespace {

constexpr std::size_t page = 4096;
constexpr std::size_t cache_line = 64;
/// Lines by which one plane is shifted against the one before it, modulo a page. Nine planes that
/// start at the same offset of a 4 KiB page would share the sets of the first-level cache and stall
/// loads behind unrelated stores; seven lines spread them over the 64 lines of a page.
constexpr std::size_t stagger_lines = 7;

/// From one plane to the next, in numbers of `size` bytes.
std::size_t plane_pitch(const Lattice& lattice, std::size_t size) {
    const std::size_t pages = (lattice.size() * size + page - 1) / page;
    return (pages * page + stagger_lines * cache_line) / size;
}

}  // namespace

template <class Real>
Populations<Real>::Populations(const Lattice& lattice)
    : lattice_(lattice),
      plane_pitch_(plane_pitch(lattice, sizeof(Real))),
      numbers_(d2q9::count * plane_pitch_, Real{0}) {}

template class Populations<double>;
template class Populations<float>;

}  // namespace tt
