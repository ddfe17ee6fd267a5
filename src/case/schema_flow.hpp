#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"

namespace tt {

// The box and the flow: see case/schema.hpp.

inline constexpr Range box_size{1e-7, 1e-1};
inline constexpr Range fluid_viscosity{1e-6, 1e3};
inline constexpr Range shear_rates{-1e6, 1e6};

template <>
struct FieldList<DomainCase> {
    using T = DomainCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{
            "length", &T::length,
            "along the flow; what leaves at one end re-enters at the other; with ports it may "
            "be left out: that of the drawing",
            box_size, "auto", "80 um"},
        FieldEntry{"width", &T::width, "from wall to wall, across the flow; likewise",
                   Range{1e-7, 1e-2}, "auto", "20 um"},
        FieldEntry{"sides", &T::sides, "what bounds the box across the flow"},
    };
};

template <>
struct FieldList<ChannelFlow> {
    using T = ChannelFlow;
    static constexpr auto entries = std::tuple{
        FieldEntry{"pseudo_shear_rate",
                   &T::pseudo_shear_rate,
                   "mean velocity / width; this key or one of the next five, all of plasma "
                   "alone; negative: flow to the left",
                   shear_rates,
                   {},
                   "500 /s"},
        FieldEntry{"mean_velocity",
                   &T::mean_velocity,
                   "over the width",
                   Range{-100.0, 100.0},
                   {},
                   "10 mm/s"},
        FieldEntry{"largest_velocity",
                   &T::largest_velocity,
                   "in the middle, 3/2 of the mean",
                   Range{-100.0, 100.0},
                   {},
                   "15 mm/s"},
        FieldEntry{"flow_rate",
                   &T::flow_rate,
                   "per depth: mean velocity * width",
                   Range{-1.0, 1.0},
                   {},
                   "0.2 mm^2/s"},
        FieldEntry{"wall_stress",
                   &T::wall_stress,
                   "shear stress on the walls, 6 mu U / H",
                   Range{-1e6, 1e6},
                   {},
                   "3.6 Pa"},
        FieldEntry{"pressure_gradient",
                   &T::pressure_gradient,
                   "pressure drop per length, 12 mu U / H^2",
                   Range{-1e12, 1e12},
                   {},
                   "360 kPa/m"},
        FieldEntry{
            "hold", &T::hold,
            "what stays constant: the pressure drop that gives plasma alone this pseudo_shear_rate "
            "(12 mu U / H^2), or the mean velocity itself, by a controller"},
    };
};
template <>
struct FieldList<PressureDrive> : FieldList<ChannelFlow> {};
template <>
struct FieldList<BodyForceDrive> : FieldList<ChannelFlow> {};

template <>
struct FieldList<ShearDrive> {
    using T = ShearDrive;
    static constexpr auto entries = std::tuple{
        FieldEntry{"shear_rate",
                   &T::shear_rate,
                   "k: the walls move with +- k * width / 2; negative: the other way",
                   shear_rates,
                   {},
                   "75 /s"},
        FieldEntry{"shear_number",
                   &T::shear_number,
                   "G = mu k a / E_s (Eq. 19), instead of shear_rate",
                   Range{1e-6, largest_shear_number},
                   {},
                   "0.2"},
    };
};

template <>
struct FieldList<SineWave> {
    using T = SineWave;
    static constexpr auto entries = std::tuple{
        FieldEntry{"frequency",
                   &T::frequency,
                   "f of the factor 1 + amplitude * sin(2 pi f t)",
                   Range{0.0, 1e6, true, false},
                   {},
                   "1 Hz"},
        FieldEntry{"amplitude", &T::amplitude, "of that factor", Range{-100.0, 100.0}, {}, "0.5"},
    };
};

template <>
struct FieldList<TableWave> {
    using T = TableWave;
    static constexpr auto entries = std::tuple{
        FieldEntry{"times",
                   &T::times,
                   "of the points of one period, from 0 to its end; it repeats",
                   Range{0.0, 1e6},
                   {},
                   "[\"0 s\", \"0.3 s\", \"1 s\"]"},
        FieldEntry{"factors",
                   &T::factors,
                   "at these times, straight between them",
                   Range{-100.0, 100.0},
                   {},
                   "[1.0, 2.0, 1.0]"},
    };
};

template <>
struct FieldList<FlowCase> {
    using T = FlowCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"drive", &T::drive,
                   "what drives the flow: a pressure drop along it, a body force, walls that move, "
                   "or nothing"},
        FieldEntry{"start", &T::start,
                   "the fluid at time zero: the flow without cells, or at rest"},
        FieldEntry{"waveform", &T::waveform,
                   "of the pressure drop or body force, in time: a factor of it"},
    };
};

template <>
struct FieldList<PlasmaCase> {
    using T = PlasmaCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"viscosity",
                   &T::viscosity,
                   "dynamic viscosity of the plasma",
                   Range{1e-5, 1e3},
                   {},
                   "1.2 cP"},
        FieldEntry{"density",
                   &T::density,
                   "density of plasma and cytoplasm",
                   Range{1.0, 1e5},
                   {},
                   "1025 kg/m^3"},
    };
};

template <>
struct FieldList<LayerCase> {
    using T = LayerCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"thickness", &T::thickness, "from the bottom wall up", box_size, {}, "5 um"},
        FieldEntry{
            "viscosity", &T::viscosity, "its dynamic viscosity", Range{1e-5, 1e3}, {}, "6 cP"},
    };
};

}  // namespace tt
