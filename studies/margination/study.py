#!/usr/bin/python3
"""Which cells come to the walls: stiff ones, white ones, large soft ones among red cells, beside cells all alike.

    studies/margination/study.py [--program build/release/tanktread] [--out results/margination] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, distance.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, over_seeds  # noqa: E402
from sweep import Sweep  # noqa: E402

WIDTH, NEAR = 40.0, 5.0  # um; a membrane nearer than NEAR to a wall: the cell is by the wall
SEEDS = (1, 2, 3)
STIFF = {"kind.marked.shear_modulus": "0.18 dyn/cm", "kind.marked.bending_modulus": "5.4e-11 dyn cm"}  # 30 times
LARGE = {"kind.marked.radius": "5 um", "kind.marked.count": "2"}
VARIANTS = {"alike": {}, "stiff": STIFF, "white": {**LARGE, **STIFF}, "large": LARGE}
WORDS = {"alike": "all alike", "stiff": "stiff", "white": "white: large and stiff", "large": "large and soft"}
PLAN = [(variant, seed) for seed in SEEDS for variant in VARIANTS]


def describe(item):
    variant, seed = item
    return f"{variant}-seed{seed}", {"cells.seed": str(seed), **VARIANTS[variant]}


def positions(results, kind):
    """Times [s]; of each cell of a kind, distance from its centre and from its membrane to the nearer wall [um], (times, cells)."""
    cells = results.cells
    mine = cells["kind"] == kind
    shape = (-1, len(np.unique(cells["cell"][mine])))
    y = 1e6 * cells["y"][mine].reshape(shape)
    return cells["time"][mine].reshape(shape)[:, 0], np.minimum(y, WIDTH - y), 1e6 * cells["wall_distance"][mine].reshape(shape)


def measure(item, results):
    variant, seed = item
    row = {"variant": variant, "seed": seed}
    for name, kind in (("marked", 1), ("red", 0)):
        time, centre, gap = positions(results, kind)
        row[f"{name}_cells"] = centre.shape[1]
        row[f"{name}_centre_start_um"] = round(float(centre[0].mean()), 2)
        for quarter, part in enumerate(np.array_split(np.arange(len(time)), 4), 1):
            row[f"{name}_centre_q{quarter}_um"] = round(float(centre[part].mean()), 2)
        late = time >= 0.5 * time[-1]
        row[f"{name}_gap_um"] = round(float(gap[late].mean()), 2)
        row[f"{name}_near_wall"] = round(float((gap[late] < NEAR).mean()), 3)
    series = results.series
    late = series["time"] >= 0.5 * series["time"][-1]
    return {**row, "cfl_gap_um": round(float(1e6 * series["cfl_gap"][late].mean()), 2),
            "cfl_profile_um": round(float(1e6 * np.nanmean(series["cfl_profile"][late])), 2),
            "mu_rel": round(float(series["mu_rel"][late].mean()), 3), "overlaps": int(series["overlaps"].max()),
            "smallest_gap_um": round(float(1e6 * np.nanmin(series["smallest_gap"])), 2)}


def late_centre(row, name):
    return 0.5 * (row[f"{name}_centre_q3_um"] + row[f"{name}_centre_q4_um"])


def verdict(rows):
    """Of each variant: marked less red in the same run, means over seeds ± standard error, beside that of the control."""
    lines, control = [], None
    for variant in VARIANTS:
        mine = [row for row in rows if row["variant"] == variant]
        centre = over_seeds(late_centre(row, "marked") - late_centre(row, "red") for row in mine)
        gap = over_seeds(row["marked_gap_um"] - row["red_gap_um"] for row in mine)
        near = over_seeds(row["marked_near_wall"] - row["red_near_wall"] for row in mine)
        error = [value.sd / np.sqrt(value.count) for value in (centre, gap, near)]
        control = control or (gap, error[1])
        z = (gap.mean - control[0].mean) / max(np.hypot(error[1], control[1]), 1e-9)
        judged = "the control" if variant == "alike" else "to the walls" if z < -2 else "to the middle" if z > 2 else "no difference beyond two errors"
        lines.append(f"- {WORDS[variant]}: marked less red, centre {centre.mean:+.2f} ± {error[0]:.2f} µm, membrane to wall {gap.mean:+.2f} ± {error[1]:.2f} µm, "
                     f"share by the wall {near.mean:+.3f} ± {error[2]:.3f}: {judged}.\n")
    return "".join(lines)


def smooth(values, width=25):
    return np.convolve(values, np.ones(width) / width, "valid")


def figure(sweep):
    """Distance of the membranes from the wall over time, means over cells and seeds, sliding over 25 rows."""
    seeds = SEEDS[:1] if sweep.is_quick else SEEDS
    curves = []
    for k, variant in enumerate(VARIANTS):
        found = [positions(sweep.run(*describe((variant, seed))), 1) for seed in seeds]
        width = min(25, len(found[0][0]) // 2)
        time = smooth(found[0][0], width)
        gap = np.mean([smooth(gap.mean(axis=1), width) for _, _, gap in found], axis=0)
        curves.append(Curve(WORDS[variant], f"with lines linetype {k + 1} linewidth 2", [time, gap]))
    sweep.draw("distance", 'set xlabel "time [s]"\nset ylabel "marked cells: membrane to nearer wall [µm]"\nset yrange [0:18]\nset key left bottom', curves)


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "0.5 um", "numerics.step_tolerance": "5 %", "time.end": "10 ms", "time.average_from": "5 ms",
                                            "output.series": "0.2 ms"})
    rows = sweep.tabulate([item for item in PLAN if item[1] == 1] if sweep.is_quick else PLAN, describe, measure)
    figure(sweep)
    (sweep.tables / "verdict.md").write_text(verdict(rows))
    print(verdict(rows), end="")
