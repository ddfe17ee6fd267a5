#pragma once

#include <string_view>
#include <tuple>

#include "base/field_list.hpp"
#include "coupling/patch.hpp"

namespace tt {

/// The fraction passes from 0 to 1 over ± half_width sites by the signed distance d to the
/// membrane, positive inside: H(s) = ½ + (15 s − 10 s³ + 3 s⁵)/16 with s = d/half_width in [−1, 1],
/// the polynomial step with two continuous derivatives.
struct SmoothedInterface {
    static constexpr std::string_view name = "smoothed";
    double half_width = 2.0;
    double reach() const { return half_width; }

    template <class Interior>
    void operator()(const Interior& interior, const LocalOutline& outline, Patch& patch) const {
        interior(outline, patch);
        smooth(outline, patch);
    }

    friend bool operator==(const SmoothedInterface&, const SmoothedInterface&) = default;

private:
    /// Replaces the indicator in `patch` by H.
    void smooth(const LocalOutline& outline, Patch& patch) const;
};

template <>
struct FieldList<SmoothedInterface> {
    static constexpr auto entries = std::tuple{FieldEntry{"smoothing_width",
                                                          &SmoothedInterface::half_width,
                                                          "half width of that change, in sites",
                                                          Range{0.5, 5.0},
                                                          {},
                                                          "2"}};
};

}  // namespace tt
