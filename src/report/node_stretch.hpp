#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/frames.hpp"
#include "io/json.hpp"
#include "membrane/hardening.hpp"
#include "membrane/in_plane/in_plane.hpp"
#include "report/results.hpp"

namespace tt {

/// Length / length without tension of the piece of membrane from each chosen node to the next one
/// of its cell. `first`: offsets of the cells in `chosen`. Empty where rest lengths are not known.
std::vector<double> chosen_stretches(const FramesHeader& header, const Frame& frame,
                                     const std::vector<int>& chosen, const std::vector<int>& first);

/// The in-plane law of a run's settings, SI.
struct MembraneLaw {
    InPlane law;
    Hardening hardening;

    /// T(λ) α(λ) [N/m]: Eqs. 10 to 12; α only where shear is hardened.
    double tension(double stretch) const;
};

/// Of the membranes that a table of the case describes: [membrane], or that of a kind. Nothing
/// where the settings do not say it.
std::optional<MembraneLaw> membrane_law(const Results& run, const std::string& table = "membrane");

/// Stretches of all frames as bytes: {low, high, bytes, tension}; byte b stands for low + (high −
/// low) b / 255, and tension[kind][b] [N/m] belongs to it in cells of each kind; null where the law
/// is not known or tension is the same at any stretch. null without stretches.
Json stretch_data(const Results& run, const std::vector<std::vector<double>>& frames);

}  // namespace tt
