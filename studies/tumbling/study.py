#!/usr/bin/python3
"""Tank-treading or tumbling of a biconcave cell: a map over viscosity ratio and shear number.

    studies/tumbling/study.py [--program build/release/tanktread] [--out results/tumbling] [-j 1] [--jobs 1]

Runs what is not there yet, then writes measured.csv beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from sweep import Sweep  # noqa: E402

RATIOS = (1, 2, 3, 4, 5, 7, 10, 20)
SHEAR_NUMBERS = (0.02, 0.1, 0.5)
STRAINED = 60.0  # k t at the end; the first half is left out
PLASMA = 1.2e-3
MODULUS = 6e-6
RADIUS = 3.91e-6 * np.sqrt(0.8916 / np.pi)  # of the circle of the cell's area, as the program takes it


def rate_of(shear_number):
    """k [/s]"""
    return shear_number * MODULUS / (PLASMA * RADIUS)


def describe(item):
    ratio, shear_number, resolution, width = item
    end = STRAINED / rate_of(shear_number) * 1e3
    return f"ratio{ratio}-G{shear_number}-dx{resolution}-width{width}", {
        "cells.cytoplasm_viscosity": f"{1.2 * ratio} cP", "flow.shear_number": shear_number, "numerics.dx": f"{resolution} um",
        "domain.width": f"{width} um", "domain.length": f"{2 * width} um", "time.end": f"{end:.6g} ms"}


def axis_turned(series):
    """Angle of the long axis over time, unwrapped [deg]: an axis comes back after half a turn."""
    return np.degrees(np.unwrap(2.0 * np.radians(series["inclination_deg"]))) / 2.0


def judge(results, rate):
    """Over the second half: what the axis and the membrane do."""
    series = results.series
    late = series["time"] > 0.5 * series["time"][-1]
    angle = axis_turned(series)[late]
    strained = (series["time"][late][-1] - series["time"][late][0]) * rate
    swept = angle[-1] - angle[0]
    turns = -swept / 180.0
    motion = "tumbles" if turns > 0.9 else "tank-treads"
    cell = results.cells.of_cell(0)
    phase = cell["phase"]
    rotation = -(phase[late][-1] - phase[late][0]) / strained  # mean over nodes, in units of k
    return {"motion": motion, "half_turns": round(turns, 2), "inclination_mean_deg": round(float(angle.mean()), 2),
            "inclination_least_deg": round(float(angle.min()), 2), "inclination_most_deg": round(float(angle.max()), 2),
            "tumbling_kT": round(2.0 * strained / turns, 2) if motion == "tumbles" else "",
            "membrane_rotation_per_k": round(float(rotation), 4),
            "taylor_inertia": round(float(series["taylor_inertia"][late].mean()), 4),
            "area_error": float(f"{series['area_error_max'].max():.2g}")}


def measure(item, results):
    ratio, shear_number, resolution, width = item
    return {"viscosity_ratio": ratio, "G": shear_number, "dx_um": resolution, "width_um": width,
            **judge(results, rate_of(shear_number))}


if __name__ == "__main__":
    plan = [(r, g, 0.2, 32) for g in SHEAR_NUMBERS for r in RATIOS]
    plan += [(r, 0.1, 0.125, 32) for r in (3, 5)]  # the grid
    Sweep(__file__, __doc__).tabulate(plan, describe, measure)
