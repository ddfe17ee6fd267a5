#!/usr/bin/python3
"""Migration of one soft cell across a channel: where it goes, how fast, and what a raised density does.

    studies/migration/study.py [--program build/release/tanktread] [--out results/migration] [-j 1] [--jobs 1]

Runs what is not there yet, then writes measured.csv and heights.csv beside this file; gnuplot draws
heights.png of the latter, if it is there: gnuplot figure.gp.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from sweep import Sweep  # noqa: E402

WIDTH = 30.0  # um
#        equilibrium, density scale, viscosity ratio, rate [/s], start [um], dx [um], end [ms]
PLAN = [("linear", 160, 1, 200, 9, 0.5, 100), ("linear", 40, 1, 200, 9, 0.5, 100), ("linear", 10, 1, 200, 9, 0.5, 100),
        ("linear", 2.5, 1, 200, 9, 0.5, 100),
        ("incompressible", 160, 1, 200, 9, 0.5, 100), ("incompressible", 40, 1, 200, 9, 0.5, 100),
        ("incompressible", 10, 1, 200, 9, 0.5, 100),
        ("incompressible", 40, 1, 200, 9, 0.25, 100),
        ("incompressible", 40, 1, 200, 6, 0.5, 400), ("incompressible", 40, 1, 200, 12, 0.5, 400),
        ("incompressible", 40, 1, 50, 9, 0.5, 400), ("incompressible", 40, 5, 200, 9, 0.5, 400),
        ("linear", 40, 5, 200, 9, 0.5, 400)]


NAMES = ("equilibrium", "density_scale", "viscosity_ratio", "rate", "start_um", "dx_um", "end_ms")
TIMES = np.arange(0.0, 100.1, 2.0)  # ms, of heights.csv


def describe(item):
    equilibrium, scale, ratio, rate, start, dx, end = item
    return f"{equilibrium}-S{scale}-ratio{ratio}-rate{rate}-from{start}-dx{dx}", {
        "numerics.equilibrium": equilibrium, "numerics.density_scale": scale, "cells.cytoplasm_viscosity": f"{1.2 * ratio} cP",
        "flow.pseudo_shear_rate": f"{rate} /s", "cells.positions": f'[["30 um", "{start} um"]]', "numerics.dx": f"{dx} um",
        "time.end": f"{end} ms"}


def measure(item, results):
    cell = results.cells
    time, height = cell["time"], 1e6 * cell["y"]
    speed = (np.interp(0.01, time, height) - np.interp(0.005, time, height)) / 5.0  # um/ms
    last = (height[-1] - np.interp(0.9 * time[-1], time, height)) / (0.1 * time[-1] * 1e3)
    return {**dict(zip(NAMES, item)), "height_10_ms_um": round(float(np.interp(0.01, time, height)), 3),
            "height_end_um": round(float(height[-1]), 3), "off_centre_end_um": round(float(0.5 * WIDTH - height[-1]), 3),
            "speed_5_to_10_ms_um_per_ms": round(float(speed), 4), "speed_last_tenth_um_per_ms": round(float(last), 5),
            "taylor_inertia_end": round(float(cell["taylor_inertia"][-1]), 4)}


def write_heights(sweep):
    """heights.csv: over time, of what starts at 9 um at 200 /s and ratio 1 on the coarse grid."""
    heights = {"time_ms": TIMES}
    for item in PLAN:
        if item[2:6] == (1, 200, 9, 0.5):
            cell = sweep.run(*describe(item)).cells
            heights[f"{item[0]} S = {item[1]}"] = np.interp(1e-3 * TIMES, cell["time"], 1e6 * cell["y"])
    np.savetxt(sweep.here / "heights.csv", np.column_stack(list(heights.values())), fmt="%.4g", delimiter=",",
               header=",".join(heights), comments="")


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    sweep.tabulate(PLAN, describe, measure)
    write_heights(sweep)
