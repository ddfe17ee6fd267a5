#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/choice.hpp"
#include "base/quantity.hpp"
#include "case/cells_case.hpp"
#include "case/geometry_case.hpp"
#include "case/wave.hpp"
#include "coupling/delta/delta.hpp"
#include "coupling/viscosity.hpp"
#include "fluid/equilibrium.hpp"
#include "grid/field.hpp"
#include "interaction/contact.hpp"
#include "membrane/bending/bending.hpp"
#include "membrane/hardening.hpp"
#include "membrane/in_plane/in_plane.hpp"

namespace tt {

/// What the user asked for, in SI units, one struct per table of the case file. An empty optional
/// is "auto" or absent; `discretise` decides. Field lists (key, member, range, meaning) are in
/// case/schema.hpp. Choices are types (base/choice.hpp); where they need no scale, those of the
/// model itself.

/// What bounds the box across the flow.
enum class Sides : std::uint8_t { walls, periodic };
template <>
inline constexpr auto words_of<Sides> = std::to_array<std::string_view>({"walls", "periodic"});

struct DomainCase {
    Length length;  ///< along the flow, periodic
    Length width;   ///< between the walls
    Sides sides = Sides::walls;

    friend bool operator==(const DomainCase&, const DomainCase&) = default;
};

/// What stays constant in a channel.
enum class Hold : std::uint8_t { pressure_drop, mean_velocity };
template <>
inline constexpr auto words_of<Hold> = std::to_array<std::string_view>({"pressure-drop",
                                                                        "mean-velocity"});

/// The fluid at time zero: the flow without cells, or at rest.
enum class FluidStart : std::uint8_t { developed, rest };
template <>
inline constexpr auto words_of<FluidStart> = std::to_array<std::string_view>({"developed", "rest"});

struct NoDrive {
    static constexpr std::string_view name = "none";
    friend bool operator==(const NoDrive&, const NoDrive&) = default;
};

/// Flow between walls at rest, asked for by one of the first six, all of plasma alone; negative: to
/// the left.
struct ChannelFlow {
    std::optional<Rate> pseudo_shear_rate;  ///< mean velocity / width
    std::optional<Velocity> mean_velocity;
    std::optional<Velocity> largest_velocity;
    std::optional<KinematicViscosity> flow_rate;  ///< per depth: mean velocity · width
    std::optional<Pressure> wall_stress;
    std::optional<PressureGradient> pressure_gradient;
    Hold hold = Hold::pressure_drop;

    friend bool operator==(const ChannelFlow&, const ChannelFlow&) = default;
};
struct PressureDrive : ChannelFlow {
    static constexpr std::string_view name = "pressure";
    friend bool operator==(const PressureDrive&, const PressureDrive&) = default;
};
struct BodyForceDrive : ChannelFlow {
    static constexpr std::string_view name = "body-force";
    friend bool operator==(const BodyForceDrive&, const BodyForceDrive&) = default;
};

/// Of G = μ k a / E_s (Eq. 19). Beyond, cells were seen to be torn on every grid.
inline constexpr double largest_shear_number = 30.0;

/// Walls that move.
struct ShearDrive {
    static constexpr std::string_view name = "shear";
    std::optional<Rate> shear_rate;      ///< k: the walls move with ± k · width / 2
    std::optional<double> shear_number;  ///< G = μ k a / E_s (Eq. 19), instead of shear_rate
    friend bool operator==(const ShearDrive&, const ShearDrive&) = default;
};

struct FlowCase {
    std::variant<NoDrive, PressureDrive, BodyForceDrive, ShearDrive> drive;
    FluidStart start = FluidStart::developed;
    WaveCase waveform;

    /// Of a channel, or of moving walls; else nothing.
    const ChannelFlow* channel() const;
    const ShearDrive* shear() const { return std::get_if<ShearDrive>(&drive); }
    friend bool operator==(const FlowCase&, const FlowCase&) = default;
};
inline const ChannelFlow* FlowCase::channel() const {
    if (const auto* pressure = std::get_if<PressureDrive>(&drive)) return pressure;
    return std::get_if<BodyForceDrive>(&drive);
}

struct PlasmaCase {
    Viscosity viscosity{1.2e-3};
    Density density{1025.0};

    friend bool operator==(const PlasmaCase&, const PlasmaCase&) = default;
};

/// A second fluid without a membrane: 0 ≤ y < thickness. For the two-layer tests.
struct LayerCase {
    std::optional<Length> thickness;
    std::optional<Viscosity> viscosity;

    friend bool operator==(const LayerCase&, const LayerCase&) = default;
};

/// What strain hardening scales (Table 1).
enum class Modality : std::uint8_t { shear, bending, area, contact };
template <>
inline constexpr auto words_of<Modality> = std::to_array<std::string_view>({"shear", "bending",
                                                                            "area", "contact"});

struct HardeningCase {
    std::vector<Modality> apply_to{Modality::shear, Modality::bending, Modality::area,
                                   Modality::contact};
    Hardening::Form form = Hardening::Form::exponential;
    Hardening::Compression compression = Hardening::Compression::symmetric;
    double D = 0.55;
    double beta = 16.0;

    friend bool operator==(const HardeningCase&, const HardeningCase&) = default;
};

struct MembraneCase {
    bool rigid = false;           ///< none of the other keys counts
    InPlane law;                  ///< its modulus is the next key
    Tension shear_modulus{6e-6};  ///< E_s
    BendingModulus bending_modulus{1.8e-19};
    Bending bending;                         ///< its modulus is the key above
    std::optional<Pressure> area_stiffness;  ///< k_p
    bool hold_area = true;
    SurfaceViscosity membrane_viscosity;  ///< η_m
    BendingViscosity bending_viscosity;   ///< η_b
    HardeningCase hardening;

    friend bool operator==(const MembraneCase&, const MembraneCase&) = default;
};

struct Case;

/// Cells that differ from those of [cells] and [membrane] by the keys that are given: [[kind]].
struct KindCase : CellTypeCase, MembraneCase {
    static constexpr bool listed = true;
    std::string name;
    std::optional<double> share;                 ///< of the number of cells
    std::optional<std::int64_t> count;           ///< instead of share
    std::vector<std::vector<Length>> positions;  ///< with layout = "explicit"

    /// As it is before its own keys are read.
    static KindCase like(const Case& c);
    friend bool operator==(const KindCase&, const KindCase&) = default;
};

/// The Morse potential (Eqs. 16, 17) in SI.
struct MorseContact {
    static constexpr std::string_view name = "morse";
    Length zero_force_distance{0.49e-6};
    InverseLength decay{3.84e6};
    SurfaceEnergy energy{1.3e-7};
    std::optional<Length>
        range;  ///< query range R; auto: where the force has fallen to 1 % of its peak attraction
    friend bool operator==(const MorseContact&, const MorseContact&) = default;
};

/// What is different between cells of two kinds: [[contact.pair]].
struct ContactPairCase {
    static constexpr bool listed = true;
    std::vector<std::string> kinds;  ///< two names, or twice the same
    std::optional<Length> zero_force_distance;
    std::optional<InverseLength> decay;
    std::optional<SurfaceEnergy> energy;
    friend bool operator==(const ContactPairCase&, const ContactPairCase&) = default;
};

struct ContactCase {
    std::variant<NoContact, MorseContact> model = MorseContact{};
    Nearest nearest = Nearest::segment;
    std::optional<bool> short_range_repulsion;  ///< auto: between walls of any shape
    std::optional<Length> repulsion_range;      ///< auto: one site
    Pressure repulsion_strength{1e3};
    std::vector<ContactPairCase> pairs;

    const MorseContact* morse() const { return std::get_if<MorseContact>(&model); }
    friend bool operator==(const ContactCase&, const ContactCase&) = default;
};

struct NumericsCase {
    std::optional<Length> dx;
    std::optional<Time> dt;
    std::optional<double> relaxation_time;  ///< τ of the plasma
    std::optional<double>
        density_scale;  ///< S: the simulation runs at S times the density (Reynolds number × S)
    double step_tolerance =
        0.01;  ///< by how much the step that `auto` takes may change D, ε, λ_C and μ_rel
    std::optional<double> node_spacing;  ///< in sites
    Collision collision;
    std::optional<Equilibrium> equilibrium;
    std::optional<Precision> precision;  ///< of what the sites hold
    std::optional<Delta> delta;
    InteriorMethod interior;
    InterfaceViscosity interface_viscosity = AreaFraction{};
    ViscosityMean viscosity_mean = HarmonicMean{};  ///< of a site that holds both fluids
    std::optional<bool> jump_correction;  ///< of slip and node velocity at membranes, second order
    bool implicit_tension = true;         ///< nodes move with what their move makes of tension
    bool fluid_only = false;              ///< cells absent: plain channel

    friend bool operator==(const NumericsCase&, const NumericsCase&) = default;
};

struct TimeCase {
    Time end;
    std::optional<Time> average_from;  ///< start of the averaging window; auto: half of the run

    friend bool operator==(const TimeCase&, const TimeCase&) = default;
};

struct OutputCase {
    std::optional<Time> series;      ///< auto: end / 500
    std::optional<Time> frames;      ///< auto: end / 50
    std::optional<Time> fields;      ///< auto: in every frame; infinite: in none
    bool compress = false;           ///< frames.h5
    Time checkpoint{300.0};          ///< wall clock
    std::vector<Time> figure_times;  ///< empty: start, a quarter, half, end

    friend bool operator==(const OutputCase&, const OutputCase&) = default;
};

struct Case {
    std::int64_t format = 1;
    std::string name;
    DomainCase domain;
    GeometryCase geometry;
    std::vector<PortCase> ports;
    std::vector<SectionCase> sections;
    std::vector<ForkCase> forks;
    std::vector<StretchCase> stretches;
    FlowCase flow;
    PlasmaCase plasma;
    LayerCase layer;
    CellsCase cells;
    MembraneCase membrane;
    std::vector<KindCase> kinds;  ///< none: all cells are as [cells] and [membrane] say
    ContactCase contact;
    NumericsCase numerics;
    TimeCase time;
    OutputCase output;

    /// Channels between ports; else the box is periodic along x.
    bool network() const { return !ports.empty(); }
    friend bool operator==(const Case&, const Case&) = default;
};

inline KindCase KindCase::like(const Case& c) {
    KindCase kind;
    static_cast<CellTypeCase&>(kind) = c.cells;
    static_cast<MembraneCase&>(kind) = c.membrane;
    return kind;
}

}  // namespace tt
