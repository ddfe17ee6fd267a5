#!/usr/bin/python3
"""Tank-treading or tumbling of a biconcave cell: a map over viscosity ratio and shear number.

    studies/tumbling/study.py [--program build/release/tanktread] [--out results/tumbling] [-j 1]

Runs what is not there yet, then writes measured.csv beside this file.
"""
import argparse
import csv
import pathlib
import subprocess
import sys

import numpy as np

here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here.parents[1] / "python"))
from tanktread import Results  # noqa: E402

RATIOS = (1, 2, 3, 4, 5, 7, 10, 20)
SHEAR_NUMBERS = (0.02, 0.1, 0.5)
STRAINED = 60.0  # k t at the end; the first half is left out
PLASMA = 1.2e-3
MODULUS = 6e-6
RADIUS = 3.91e-6 * np.sqrt(0.8916 / np.pi)  # of the circle of the cell's area, as the program takes it


def run(program, out, ratio, shear_number, threads, resolution, width):
    name = f"ratio{ratio}-G{shear_number}-dx{resolution}-width{width}"
    rate = shear_number * MODULUS / (PLASMA * RADIUS)
    end = STRAINED / rate * 1e3
    command = [program, "run", here / "case.toml", "-o", out / name, "-j", threads, "--progress", "none",
               "--set", f"cells.cytoplasm_viscosity={1.2 * ratio} cP", "--set", f"flow.shear_number={shear_number}",
               "--set", f"numerics.dx={resolution} um", "--set", f"domain.width={width} um",
               "--set", f"domain.length={2 * width} um", "--set", f"time.end={end:.6g} ms"]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return Results(out / name), rate


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


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--program", default=here.parents[1] / "build/release/tanktread")
    options.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/tumbling"))
    options.add_argument("-j", "--threads", default=1)
    given = options.parse_args()
    plan = [(r, g, 0.2, 32) for g in SHEAR_NUMBERS for r in RATIOS]
    plan += [(r, 0.1, 0.125, 32) for r in (3, 5)]  # the grid
    rows = []
    for ratio, shear_number, resolution, width in plan:
        results, rate = run(given.program, given.out, ratio, shear_number, given.threads, resolution, width)
        rows.append({"viscosity_ratio": ratio, "G": shear_number, "dx_um": resolution, "width_um": width,
                     **judge(results, rate)})
        print(*rows[-1].values(), flush=True)
        with open(here / "measured.csv", "w", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    main()
