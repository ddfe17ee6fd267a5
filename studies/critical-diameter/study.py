#!/usr/bin/python3
"""From which diameter on a stiff cell is bumped by an array of posts, against what streamlines say.

    studies/critical-diameter/study.py [--program build/release/tanktread] [--out results/critical-diameter] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, paths.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, read_reference  # noqa: E402
from sweep import Sweep  # noqa: E402

PERIOD, FALL = 240.0, 8.0  # um: after which the columns repeat; a third of the way from post to post, more than a bumped cell sways
DIAMETERS = (3.0, 3.4, 3.55, 3.7, 4.0, 4.4, 5.0)  # um
COARSE, FINE, FINEST = 0.375, 0.3, 0.24  # um
PLAN = ([(diameter, COARSE) for diameter in DIAMETERS] + [(diameter, FINE) for diameter in (3.4, 3.55, 3.7, 3.85, 4.0)]
        + [(diameter, FINEST) for diameter in (3.7, 3.85, 4.0)])


def describe(item):
    """Half of the case's shear modulus: cells of this size are then still round, and steps are longer."""
    diameter, dx = item
    return f"diameter{diameter}-dx{dx}", {
        "cells.radius": f"{0.5 * diameter:.4g} um", "numerics.dx": f"{dx} um", "membrane.shear_modulus": "5e-2 dyn/cm",
        "membrane.bending_modulus": "1e-11 dyn cm", "time.end": "0.85 s", "output.series": "1 ms", "output.frames": "0.1 s",
        "output.fields": "never"}, "08-posts"


def path(results):
    return 1e6 * results.cells["x"], 1e6 * results.cells["y"]


def measure(item, results):
    """Bumped is what never falls back below a post. The climb is over the last ten columns that were passed."""
    diameter, dx = item
    x, y = path(results)
    climb = (y[-1] - np.interp(x[-1] - PERIOD, x, y)) / PERIOD
    fall = float(np.max(np.maximum.accumulate(y) - y))
    cells = results.cells
    return {"diameter_um": diameter, "dx_um": dx, "way_um": round(float(x[-1]), 1), "climb_of_way": round(float(climb), 4),
            "largest_fall_um": round(fall, 2), "bumped": bool(fall < FALL), "lambda_C_max": round(float(cells["lambda_C"].max()), 3),
            "nearest_to_a_post_um": round(1e6 * float(cells["wall_distance"].min()), 3)}


def predictions():
    """Critical diameters [um] of this array: finite elements; a parabola between the posts; the fit to experiments of Davis, 1.4 G e^0.48."""
    streamlines = next(float(row["value"]) for row in read_reference("stokes_networks.csv") if row["quantity"] == "critical diameter by streamlines")
    return {"streamlines": streamlines, "a parabola in the gap": 3.916, "the fit of Davis": 4.64}


def bracket(rows):
    """Largest diameter that zigzags and smallest that is bumped."""
    return (max([row["diameter_um"] for row in rows if not row["bumped"]], default=np.nan),
            min([row["diameter_um"] for row in rows if row["bumped"]], default=np.nan))


def verdict(rows):
    """Which prediction is nearest to the middle of the bracket, and by how much it is off."""
    texts = []
    for dx in (COARSE, FINE, FINEST):
        low, high = bracket([row for row in rows if row["dx_um"] == dx])
        seen = 0.5 * (low + high)
        name, value = min(predictions().items(), key=lambda pair: abs(pair[1] - seen))
        texts.append(f"- Spacing {dx:g} µm: up to {low:g} µm cells zigzag, from {high:g} µm on they are bumped. Nearest: {name}, {value:.2f} µm; "
                     f"the middle of the bracket is {100 * (seen / value - 1):+.0f} % off.\n")
    return "".join(texts)


def figure(sweep, plan):
    curves = []
    for item in plan:
        if item[1] != COARSE:
            continue
        x, y = path(sweep.run(*describe(item)))
        curves.append(Curve(f"{item[0]:g} um", "with lines", [x[::4], y[::4]]))
    sweep.draw("paths", 'set xlabel "way along the flow [um]"\nset ylabel "way across [um]"\nset xrange [0:*]\nset key left top', curves)


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "0.75 um", "cells.radius": "3 um", "time.end": "5 ms", "output.frames": "5 ms"})
    plan = PLAN[::6] if sweep.is_quick else PLAN
    rows = sweep.tabulate(plan, describe, measure)
    figure(sweep, plan)
    (sweep.tables / "verdict.md").write_text(verdict(rows))
    print(verdict(rows), end="")
