#!/usr/bin/python3
"""A cell in unbounded shear, by extrapolation in the size of the box.

    studies/unbounded/study.py [--program build/release/tanktread] [--out results/unbounded] [-j 1] [--jobs 1]

Runs what is not there yet (some minutes on one core), then writes measured.csv and table.md beside this file.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import read_reference  # noqa: E402
from sweep import Sweep, mean_of  # noqa: E402

SHEAR_NUMBER = 0.2
RATIOS = (1, 5)
WIDTHS = (40, 60, 80)  # um; four times as long
QUANTITIES = {"D_inertia": "taylor_inertia", "strain": "strain", "kT": "tank_treading_kT", "inclination_deg": "inclination_deg"}


def describe(item):
    """The fluid of the widest box needs k t of about Re H²/(a π)² to settle: hence a density scale below that of auto."""
    ratio, width = item
    return f"ratio{ratio}-width{width}", {
        "flow.shear_number": SHEAR_NUMBER, "cells.cytoplasm_viscosity": f"{1.2 * ratio:g} cP", "domain.width": f"{width} um",
        "domain.length": f"{4 * width} um", "numerics.dx": "0.4 um", "numerics.density_scale": 29,
        "time.end": "80 ms", "time.average_from": "64 ms", "output.frames": "80 ms"}, "03-cell-in-shear"


def measure(item, results):
    ratio, width = item
    return {"viscosity_ratio": ratio, "width_um": width,
            **{name: round(mean_of(results, key), 6) for name, key in QUANTITIES.items()}}


def exact(table, ratio):
    for row in read_reference(f"capsule_shear_{table}.csv"):
        if float(row["viscosity_ratio"]) == ratio and float(row["G"]) == SHEAR_NUMBER:
            return {name: float(row[name]) for name in QUANTITIES}


def power(values):
    """p of q = q∞ + c/width^p through the three widths, by bisection."""
    seen = (values[0] - values[1]) / (values[1] - values[2])

    def ratio(p):
        a, b, c = (width**-p for width in WIDTHS)
        return (a - b) / (b - c)

    low, high = 0.1, 8.0
    if not ratio(low) < seen < ratio(high):
        return math.nan
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if ratio(middle) < seen else (low, middle)
    return low


def table(rows):
    """The extrapolation in 1/width² from the two widest boxes, taken off the error that this grid has in the box of 40 um."""
    lines = [("ratio", "quantity", *(f"{width} µm" for width in WIDTHS), "power seen", "extrapolated", "same, grid error taken off", "exact",
              "difference"), ("---",) * (len(WIDTHS) + 7)]
    for ratio in RATIOS:
        mine = [row for row in rows if row["viscosity_ratio"] == ratio]
        for name in QUANTITIES:
            values = [row[name] for row in mine]
            a, b = WIDTHS[-2] ** -2, WIDTHS[-1] ** -2
            far = values[-1] + (values[-1] - values[-2]) * b / (a - b)
            corrected = far * exact("channel40", ratio)[name] / values[0]
            goal = exact("unbounded", ratio)[name]
            lines.append((str(ratio), name, *(f"{value:.5g}" for value in values), f"{power(values):.1f}", f"{far:.5g}",
                          f"{corrected:.5g}", f"{goal:.5g}", f"{100 * (corrected / goal - 1):+.2f} %"))
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    rows = sweep.tabulate([(ratio, width) for ratio in RATIOS for width in WIDTHS], describe, measure)
    (sweep.here / "table.md").write_text(table(rows))
