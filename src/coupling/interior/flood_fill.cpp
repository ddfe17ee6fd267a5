#include "coupling/interior/flood_fill.hpp"

#include <algorithm>
#include <cstdint>

#include "coupling/interior/crossing.hpp"

namespace tt {
namespace {

/// Per site, whether the outline cuts the link to its right and to its upper neighbour an odd
/// number of times.
struct CutLinks {
    std::vector<std::uint8_t> right, up;
};

CutLinks cut_links(const LocalOutline& outline, const Patch& patch) {
    CutLinks cut{std::vector<std::uint8_t>(patch.value.size()),
                 std::vector<std::uint8_t>(patch.value.size())};
    for (int k = 0; k < outline.segments(); ++k) {
        const Vec2 a{snapped(outline.x[k]), snapped(outline.y[k])};
        const Vec2 b{snapped(outline.x[k + 1]), snapped(outline.y[k + 1])};
        const int c0 = static_cast<int>(std::floor(std::min(a.x, b.x))) - 1;
        const int c1 = static_cast<int>(std::floor(std::max(a.x, b.x))) + 1;
        const int r0 = static_cast<int>(std::floor(std::min(a.y, b.y))) - 1;
        const int r1 = static_cast<int>(std::floor(std::max(a.y, b.y))) + 1;
        for (int r = std::max(r0, 0); r <= std::min(r1, patch.height - 2); ++r) {
            for (int c = std::max(c0, 0); c <= std::min(c1, patch.width - 2); ++c) {
                const Vec2 site{c + 0.5, r + 0.5};
                const std::size_t at = static_cast<std::size_t>(r) * patch.width + c;
                if (passes(a.y, b.y, site.y) &&
                    right_of(a, b, site) != right_of(a, b, {site.x + 1.0, site.y}))
                    cut.right[at] ^= 1;
                if (passes(a.x, b.x, site.x) &&
                    above(a, b, site) != above(a, b, {site.x, site.y + 1.0}))
                    cut.up[at] ^= 1;
            }
        }
    }
    return cut;
}

}  // namespace

void FloodFill::operator()(const LocalOutline& outline, Patch& patch) const {
    const CutLinks cut = cut_links(outline, patch);
    std::vector<std::uint8_t> seen(patch.value.size());
    std::vector<std::int32_t> front{0};  // site (0, 0) of a patch lies outside
    seen[0] = 1;
    patch.value[0] = 0.0;
    const auto visit = [&](std::int32_t from, std::int32_t to, bool crosses) {
        if (seen[to]) return;
        seen[to] = 1;
        patch.value[to] = crosses ? 1.0 - patch.value[from] : patch.value[from];
        front.push_back(to);
    };
    while (!front.empty()) {
        const std::int32_t at = front.back();
        front.pop_back();
        const int c = at % patch.width;
        const int r = at / patch.width;
        if (c + 1 < patch.width) visit(at, at + 1, cut.right[at]);
        if (c > 0) visit(at, at - 1, cut.right[at - 1]);
        if (r + 1 < patch.height) visit(at, at + patch.width, cut.up[at]);
        if (r > 0) visit(at, at - patch.width, cut.up[at - patch.width]);
    }
}

}  // namespace tt
