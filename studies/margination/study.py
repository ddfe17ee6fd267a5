#!/usr/bin/python3
"""Which cells come to the walls: stiff, white, large soft, or small stiff ones among red cells; beside cells all alike.

    studies/margination/study.py [--program build/release/tanktread] [--out results/margination] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, place.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, over_seeds  # noqa: E402
from sweep import Sweep  # noqa: E402

NEAR = 5.0  # um; a membrane nearer than NEAR to a wall: the cell is by the wall
STIFF = {"kind.marked.shear_modulus": "0.18 dyn/cm", "kind.marked.bending_modulus": "5.4e-11 dyn cm"}  # 30 times
LARGE = {"kind.marked.radius": "5 um", "kind.marked.count": "2"}
SMALL = {"kind.marked.radius": "1.6 um", "kind.marked.count": "12"}
SLOW = {"flow.mean_velocity": "1 mm/s", "time.end": "4000 ms", "time.average_from": "2000 ms", "output.series": "8 ms", "output.frames": "200 ms"}
LONG = {"cells.shape": "ellipse", "cells.aspect_ratio": "2", "cells.radius": "2.6 um", "kind.marked.shape": "circle"}
NARROW = {"domain.width": "20 um", "domain.length": "80 um", "flow.mean_velocity": "0.5 mm/s", "kind.marked.count": "1"}
VARIANTS = {  # in words; keys; seeds; radii of marked and red [um]
    "alike": ("all alike", {}, (1, 2, 3), (2.8, 2.8)),
    "stiff": ("stiff", STIFF, (1, 2, 3, 4, 5), (2.8, 2.8)),
    "white": ("white: large and stiff", {**LARGE, **STIFF}, (1, 2, 3), (5.0, 2.8)),
    "large": ("large and soft", LARGE, (1, 2, 3), (5.0, 2.8)),
    "small": ("small and stiff", {**SMALL, **STIFF}, (1, 2, 3), (1.6, 2.8)),
    "slow": ("white among long red cells, 150 /s", {**LARGE, **STIFF, **SLOW, **LONG}, (1, 2), (5.0, 2.6)),
    "narrow": ("white among long red cells, 20 µm wide, 150 /s", {**LARGE, **STIFF, **SLOW, **LONG, **NARROW}, (1, 2), (5.0, 2.6)),
    "inertia": ("white, S = 4, 0.3 s", {**LARGE, **STIFF, "numerics.density_scale": "4", "time.end": "300 ms", "time.average_from": "150 ms"}, (2,), (5.0, 2.8)),
    "calm": ("small and stiff, S = 15, 0.4 s", {**SMALL, **STIFF, "numerics.density_scale": "15", "time.end": "400 ms", "time.average_from": "200 ms"}, (1,), (1.6, 2.8))}
CURVES = ("alike", "stiff", "white", "large", "small")
PLAN = [(variant, seed) for variant, (_, _, seeds, _) in VARIANTS.items() for seed in seeds]


def describe(item):
    variant, seed = item
    return f"{variant}-seed{seed}", {"cells.seed": str(seed), **VARIANTS[variant][1]}


def positions(results, kind):
    """Times [s]; of each cell of a kind, distance from its centre and from its membrane to the nearer wall [um], (times, cells)."""
    cells, width = results.cells, 1e6 * results.grid["width"]
    mine = cells["kind"] == kind
    shape = (-1, len(np.unique(cells["cell"][mine])))
    y = 1e6 * cells["y"][mine].reshape(shape)
    return cells["time"][mine].reshape(shape)[:, 0], np.minimum(y, width - y), 1e6 * cells["wall_distance"][mine].reshape(shape)


def place(centre, radius, width=40.0):
    """Of a centre [um] from the wall: 0 where a round cell touches the wall, 1 in the middle; 1/2 on average where cells are spread evenly."""
    return (centre - radius) / (0.5 * width - radius)


def measure(item, results):
    """Places at the start and over the quarters of the run; what is averaged is over its second half."""
    variant, seed = item
    row = {"variant": variant, "seed": seed}
    for kind, name in ((1, "marked"), (0, "red")):
        time, centre, gap = positions(results, kind)
        at = place(centre, VARIANTS[variant][3][1 - kind], 1e6 * results.grid["width"])
        late = time >= 0.5 * time[-1]
        row |= {f"{name}_cells": centre.shape[1], f"{name}_start": round(float(at[0].mean()), 3)}
        row |= {f"{name}_quarter{k}": round(float(at[part].mean()), 3) for k, part in enumerate(np.array_split(np.arange(len(time)), 4), 1)}
        row |= {f"{name}_place": round(float(at[late].mean()), 3), f"{name}_centre_um": round(float(centre[late].mean()), 2),
                f"{name}_gap_um": round(float(gap[late].mean()), 2), f"{name}_by_wall": round(float((gap[late] < NEAR).mean()), 3)}
    series = results.series
    late = series["time"] >= 0.5 * series["time"][-1]
    way = float(np.trapz(series["mean_velocity"], series["time"]))
    return {**row, "cfl_gap_um": round(float(1e6 * series["cfl_gap"][late].mean()), 2),
            "cfl_profile_um": round(float(1e6 * np.nanmean(series["cfl_profile"][late])), 2),
            "mu_rel": round(float(series["mu_rel"][late].mean()), 3), "way_mm": round(1e3 * way, 2), "overlaps": int(series["overlaps"].max()),
            "smallest_gap_um": round(float(1e6 * np.nanmin(series["smallest_gap"])), 2), "turn_max_deg": round(float(series["turn_max_deg"].max()), 0)}


def against(rows, variant):
    """Marked less red in the same run: places and shares by the wall, as (mean, standard error over seeds)."""
    mine = [row for row in rows if row["variant"] == variant]
    values = [over_seeds(row[f"marked_{name}"] - row[f"red_{name}"] for row in mine) for name in ("place", "by_wall")]
    return [(value.mean, value.sd / np.sqrt(value.count)) for value in values]


def verdict(rows):
    control = against(rows, "alike")
    lines = []
    for variant, (words, _, _, _) in VARIANTS.items():
        (at, error), (by_wall, by_wall_error) = against(rows, variant)
        beyond = 2.0 * np.hypot(error, control[0][1])
        judged = ("the control" if variant == "alike" else "one seed" if len([row for row in rows if row["variant"] == variant]) < 2 else
                  "to the walls" if at < -beyond else "to the middle" if at > beyond else "no difference beyond two errors")
        one = judged == "one seed"
        lines.append(f"- {words}: marked less red, place {at:+.3f}" + f" ± {error:.3f}" * (not one) + f", share by the wall {by_wall:+.3f}"
                     + f" ± {by_wall_error:.3f}" * (not one) + f": {judged}.\n")
    return "".join(lines)


def figure(sweep, plan):
    """Place of the marked cells over time, means over cells and seeds, sliding over 50 ms."""
    curves = [Curve("spread evenly", "with lines linecolor 'gray60'", [[0, 1.0], [0.5, 0.5]])]
    for k, variant in enumerate(CURVES):
        radius = VARIANTS[variant][3][0]
        found = [positions(sweep.run(*describe(item)), 1)[:2] for item in plan if item[0] == variant]
        window = np.ones(min(25, len(found[0][0]) // 2))
        window /= window.sum()
        at = np.mean([np.convolve(place(centre, radius).mean(axis=1), window, "valid") for _, centre in found], axis=0)
        curves.append(Curve(VARIANTS[variant][0], f"with lines linetype {k + 1} linewidth 2", [np.convolve(found[0][0], window, "valid"), at]))
    sweep.draw("place", 'set xlabel "time [s]"\nset ylabel "wall 0, middle 1"\nset xrange [0:1]\nset yrange [0:1]\nset key outside right center',
               curves, size=(680, 330))


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "0.4 um", "numerics.step_tolerance": "5 %", "numerics.density_scale": "auto", "time.end": "8 ms",
                                            "time.average_from": "4 ms", "output.series": "0.2 ms"})
    plan = [item for item in PLAN if item[1] == VARIANTS[item[0]][2][0]] if sweep.is_quick else PLAN
    rows = sweep.tabulate(plan, describe, measure)
    figure(sweep, plan)
    (sweep.tables / "verdict.md").write_text(verdict(rows))
    print(verdict(rows), end="")
