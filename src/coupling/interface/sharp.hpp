#pragma once

#include <string_view>

#include "coupling/patch.hpp"

namespace tt {

/// A site has the viscosity of the side on which it lies. First order: the membrane is in effect
/// displaced by up to half a site.
struct SharpInterface {
    static constexpr std::string_view name = "sharp";
    static constexpr double reach() { return 0.0; }

    /// Sets the fractions of `patch`; `interior` is a ScanLine or a FloodFill.
    template <class Interior>
    void operator()(const Interior& interior, const LocalOutline& outline, Patch& patch) const {
        interior(outline, patch);
    }
    friend bool operator==(const SharpInterface&, const SharpInterface&) = default;
};

}  // namespace tt
