#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/choose.hpp"
#include "simulation/model.hpp"
#include "simulation/state.hpp"

namespace tt {

/// A number that must stay below its limit for the explicit step to be stable.
struct Bound {
    std::string name;
    double value = 0.0;
    double limit = 0.0;
    std::string definition;
    std::size_t kind = 0;  ///< of whose membrane
    double margin() const { return value > 0.0 ? limit / value : 1e9; }
};

/// How far apart membranes are looked for at the start [sites].
inline constexpr double gap_reach = 3.0;

/// Something the user should know before the run: what is so, and which key to change.
struct Advice {
    enum class Weight : std::uint8_t { consider, refuse };
    Weight weight = Weight::consider;
    std::string text;
};

/// Of the cells of one kind at the start.
struct KindFigures {
    std::string name;  ///< empty where there is but one
    bool rigid = false;
    int cells = 0;
    double radius_sites = 0.0;
    double viscosity_ratio = 1.0;
    double shear_number = 0.0;          ///< G
    double bending_length = 0.0;        ///< in sites
    double stretching_viscosity = 0.0;  ///< Bq = η_m/(μ a)
    double bending_viscosity = 0.0;     ///< Bb = η_b/(μ a³)

    /// k t in which a cell comes nearer to its steady state by a factor of e, where the viscosity
    /// of its membrane decides that.
    double settling_time() const {
        return (stretching_viscosity + 1.0 + viscosity_ratio) * shear_number / 3.0;
    }
};

/// What `check` answers to "which dx, dt, tau?": everything that follows from a case before a step
/// is made.
struct Appraisal {
    std::int64_t sites = 0, steps = 0;
    int cells = 0, nodes = 0;
    std::vector<int> feed_cells;  ///< in the channel of each feed, as Model::feeds
    double radius_sites = 0.0;    ///< radius of a cell
    double cell_area = 0.0;       ///< mean, in sites
    double node_distance = 0.0;   ///< mean, in sites
    double hematocrit = 0.0, viscosity_ratio = 1.0;  ///< of kinds that farthest from 1
    std::vector<KindFigures> kinds;
    double bending_length = 0.0;    ///< √(E_b/E_s), in sites, of membranes the least
    double contact_distance = 0.0;  ///< of zero force, in sites; 0: no contact model
    double start_turn_deg = 0.0;    ///< largest between neighbouring segments of the first shapes
    double start_radius = 0.0;      ///< their smallest radius of curvature, in sites
    double smallest_gap = 0.0;      ///< between membranes at the start, in sites; at most gap_reach
    double wall_distance = 0.0;     ///< of the nearest membrane at the start, in sites
    double start_stretch = 0.0;     ///< largest |l / l₀ − 1| of a segment at the start
    double tau_plasma = 0.0, tau_cytoplasm = 0.0;
    double shear_number = 0.0;       ///< G = μ k a / E_s (Eq. 19), of kinds the largest
    double cell_reynolds = 0.0;      ///< ρ k a² / μ, physical
    double cell_reynolds_run = 0.0;  ///< times S: as run
    double channel_reynolds = 0.0;   ///< ρ U H / μ, physical
    double mach = 0.0;               ///< largest speed / speed of sound
    double strained_time = 0.0;      ///< k t_end
    double transits = 0.0;           ///< U t_end / length, channels
    std::int64_t frames = 0;
    std::int64_t frame_bytes = 0, disk_bytes = 0;
    std::vector<Bound> bounds;
    std::vector<Advice> advice;

    bool refused() const;
    /// Whether nothing has a membrane.
    bool rigid() const;
};

/// Judges a case. Limits of accuracy are those measured in docs/theory/time-step.md, limits of
/// stability those that stand beside each explicit term (membrane/stability.hpp).
Appraisal appraise(const Case& c, const Choice& choice, const Model& model, const State& initial);

}  // namespace tt
