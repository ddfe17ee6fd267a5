#pragma once

#include "base/field_list.hpp"
#include "case/case.hpp"
#include "case/schema_cells.hpp"
#include "case/schema_contact.hpp"
#include "case/schema_flow.hpp"
#include "case/schema_geometry.hpp"

namespace tt {

// One list per table of the case file. From these lists alone come parsing, range faults, faults of
// unknown keys, unit conversion, the reference of keys (docs/keys.md) and the echo in
// resolved.toml. A field whose default lies outside its own range must be given by the user. Ranges
// are wide, but finite: no product of numbers within them overflows, and each end of each is tried
// (tests/app/ranges.py).

template <>
struct FieldList<NumericsCase> {
    using T = NumericsCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"dx", &T::dx, "site spacing", Range{1e-9, 1e-3}, {}, "0.2 um"},
        FieldEntry{"dt", &T::dt, "time step", Range{1e-15, 1.0}, {}, "1 us"},
        FieldEntry{"relaxation_time",
                   &T::relaxation_time,
                   "tau of the plasma, in steps",
                   Range{0.5, 20.0, true, false},
                   {},
                   "1.1"},
        FieldEntry{"density_scale",
                   &T::density_scale,
                   "S: the run has S times the density, hence S times the Reynolds number, and "
                   "larger time steps",
                   Range{1.0, 1e4},
                   {},
                   "20"},
        FieldEntry{"step_tolerance",
                   &T::step_tolerance,
                   "by how much the time step that auto takes may change D, strain, lambda_C and "
                   "mu_rel; stability may ask for a shorter one",
                   Range{1e-4, 0.2},
                   {},
                   "1 %"},
        FieldEntry{"node_spacing",
                   &T::node_spacing,
                   "of the membrane, in sites",
                   Range{0.35, 2.0},
                   {},
                   "0.8"},
        FieldEntry{"collision", &T::collision, "two relaxation times, or the one of Eq. 1"},
        FieldEntry{"equilibrium",
                   &T::equilibrium,
                   "linear is Stokes flow; incompressible and full (Eq. 2) keep inertia; auto: "
                   "incompressible where the flow carries cells along, else linear",
                   any_value,
                   {},
                   "linear"},
        FieldEntry{"precision",
                   &T::precision,
                   "of all fields of sites: single takes half the memory and traffic; membranes "
                   "are in double either way; auto: single where there are cells and "
                   "step_tolerance is 1 % or more",
                   any_value,
                   {},
                   "single"},
        FieldEntry{
            "delta",
            &T::delta,
            "kernel between sites and nodes (Eq. 8 is cosine4); auto: roma3, but peskin4 where "
            "the viscosities differ by more than ten times",
            any_value,
            {},
            "roma3"},
        FieldEntry{"interior", &T::interior, "how the sites inside a cell are found"},
        FieldEntry{"interface_viscosity", &T::interface_viscosity,
                   "how viscosity changes across the membrane"},
        FieldEntry{"viscosity_mean", &T::viscosity_mean,
                   "viscosity of a site that holds both fluids"},
        FieldEntry{"jump_correction",
                   &T::jump_correction,
                   "take off the first-order slip and velocity error that smearing a membrane "
                   "makes; auto: "
                   "where the viscosities differ by at most twenty times",
                   any_value,
                   {},
                   "true"},
        FieldEntry{"implicit_tension", &T::implicit_tension,
                   "nodes move with what their own move makes of the tension, which allows longer "
                   "steps"},
        FieldEntry{"fluid_only", &T::fluid_only, "leave the cells out: the plain channel"},
    };
};

template <>
struct FieldList<TimeCase> {
    using T = TimeCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"end", &T::end, "simulated time", Range{0.0, 1e6, true, false}, {}, "80 ms"},
        FieldEntry{"average_from",
                   &T::average_from,
                   "start of the averages in summary.json; auto: half of the run",
                   Range{0.0, 1e6},
                   {},
                   "40 ms"},
    };
};

template <>
struct FieldList<OutputCase> {
    using T = OutputCase;
    static constexpr auto entries = std::tuple{
        FieldEntry{"series",
                   &T::series,
                   "between two rows of series.csv and cells.csv; auto: end / 500",
                   positive,
                   {},
                   "0.1 ms"},
        FieldEntry{"frames",
                   &T::frames,
                   "between two frames of frames.h5; auto: end / 50",
                   positive,
                   {},
                   "1 ms"},
        FieldEntry{
            "fields", &T::fields,
            "between two frames that hold velocity, pressure and cytoplasm too; auto: all do",
            positive, "never", "10 ms"},
        FieldEntry{
            "compress", &T::compress,
            "deflate frames.h5: smaller by some 40 %, at 5 to 10 times the time to write it"},
        FieldEntry{"checkpoint",
                   &T::checkpoint,
                   "between two checkpoints, in time on the clock on the wall",
                   Range{6.0, 6e6},
                   {},
                   "5 min"},
        FieldEntry{"figure_times",
                   &T::figure_times,
                   "of the figures of cells; none given: start, quarter, half, end",
                   Range{0.0, 1e6},
                   {},
                   "[\"0 ms\", \"40 ms\", \"80 ms\"]"},
    };
};

template <>
struct FieldList<Case> {
    using T = Case;
    static constexpr auto entries = std::tuple{
        FieldEntry{"format", &T::format, "of this file", Range{1.0, 1.0}, {}, "1"},
        FieldEntry{"name",
                   &T::name,
                   "of the run and of its directory in results/; else that of the file",
                   any_value,
                   {},
                   "channel-500-LD"},
        FieldEntry{"domain", &T::domain, "the box"},
        FieldEntry{"geometry", &T::geometry, "the walls, where they are not those of the box"},
        FieldEntry{"port", &T::ports,
                   "where fluid goes in and out of what is drawn; a table for each port"},
        FieldEntry{
            "section", &T::sections,
            "a line across a channel at which flow and cells are measured; a table for each"},
        FieldEntry{"fork", &T::forks,
                   "sections before and behind a place where a channel parts; a table for each"},
        FieldEntry{"stretch", &T::stretches,
                   "a channel between two sections, of which the resistance is told; a table for "
                   "each"},
        FieldEntry{"flow", &T::flow, "what drives the flow"},
        FieldEntry{"plasma", &T::plasma, "the fluid around the cells"},
        FieldEntry{"layer", &T::layer,
                   "a second fluid along the bottom wall, without a membrane, for tests"},
        FieldEntry{"cells", &T::cells, "the red blood cells"},
        FieldEntry{"membrane", &T::membrane, "their membrane"},
        FieldEntry{
            "kind", &T::kinds,
            "cells that are not all alike: one such table for each kind. Also any key of "
            "[cells] from shape to cytoplasm_viscosity, and any of [membrane]; its hardening "
            "is [kind.hardening]. What is not given is as there"},
        FieldEntry{"contact", &T::contact, "forces between cells"},
        FieldEntry{"numerics", &T::numerics, "how it is computed; all of it may be left out"},
        FieldEntry{"time", &T::time, "how long"},
        FieldEntry{"output", &T::output, "what is written, and how often"},
    };
};

}  // namespace tt
