#include "fluid/populations.hpp"

namespace tt {
namespace {

constexpr std::size_t doubles_per_page = 512;
constexpr std::size_t doubles_per_line = 8;
/// Lines by which one plane is shifted against the one before it, modulo a page. Nine planes that
/// start at the same offset of a 4 KiB page would share the sets of the first-level cache and stall
/// loads behind unrelated stores; seven lines spread them over the 64 lines of a page.
constexpr std::size_t stagger_lines = 7;

std::size_t plane_pitch(const Lattice& lattice) {
    const std::size_t pages = (lattice.size() + doubles_per_page - 1) / doubles_per_page;
    return pages * doubles_per_page + stagger_lines * doubles_per_line;
}

}  // namespace

Populations::Populations(const Lattice& lattice)
    : lattice_(lattice), storage_(d2q9::count * plane_pitch(lattice), 0.0) {
    place_planes();
}

Populations::Populations(const Populations& other)
    : phase(other.phase), lattice_(other.lattice_), storage_(other.storage_) {
    place_planes();
}

Populations& Populations::operator=(const Populations& other) {
    phase = other.phase;
    lattice_ = other.lattice_;
    storage_ = other.storage_;
    place_planes();
    return *this;
}

void Populations::place_planes() {
    for (int i = 0; i < d2q9::count; ++i) plane_[i] = storage_.data() + i * plane_pitch(lattice_);
}

}  // namespace tt
