#!/usr/bin/python3
"""Migration of one soft cell across a channel: where it goes, how fast, and what a raised density does.

    studies/migration/study.py [--program build/release/tanktread] [--out results/migration] [-j 1]

Runs what is not there yet, then writes measured.csv and heights.csv beside this file; gnuplot draws
heights.png of the latter, if it is there: gnuplot figure.gp.
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


def run(program, out, threads, equilibrium, scale, ratio, rate, start, dx, end):
    directory = out / f"{equilibrium}-S{scale}-ratio{ratio}-rate{rate}-from{start}-dx{dx}"
    command = [program, "run", here / "case.toml", "-o", directory, "-j", threads, "--progress", "none",
               "--set", f"numerics.equilibrium={equilibrium}", "--set", f"numerics.density_scale={scale}",
               "--set", f"cells.cytoplasm_viscosity={1.2 * ratio} cP", "--set", f"flow.pseudo_shear_rate={rate} /s",
               "--set", f'cells.positions=[["30 um", "{start} um"]]', "--set", f"numerics.dx={dx} um",
               "--set", f"time.end={end} ms"]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return Results(directory).cells


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", default=here.parents[1] / "build/release/tanktread")
    options.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/migration"))
    options.add_argument("-j", "--threads", default=1)
    given = options.parse_args()
    rows = []
    heights = {"time_ms": np.arange(0.0, 100.1, 2.0)}
    for plan in PLAN:
        cell = run(given.program, given.out, given.threads, *plan)
        time, height = cell["time"], 1e6 * cell["y"]
        speed = (np.interp(0.01, time, height) - np.interp(0.005, time, height)) / 5.0  # um/ms
        names = ("equilibrium", "density_scale", "viscosity_ratio", "rate", "start_um", "dx_um", "end_ms")
        rows.append({**dict(zip(names, plan)), "height_10_ms_um": round(float(np.interp(0.01, time, height)), 3),
                     "height_end_um": round(float(height[-1]), 3),
                     "off_centre_end_um": round(float(0.5 * WIDTH - height[-1]), 3),
                     "speed_5_to_10_ms_um_per_ms": round(float(speed), 4),
                     "speed_last_tenth_um_per_ms": round(float((height[-1] - np.interp(0.9 * time[-1], time, height))
                                                               / (0.1 * time[-1] * 1e3)), 5),
                     "taylor_inertia_end": round(float(cell["taylor_inertia"][-1]), 4)})
        if plan[2:6] == (1, 200, 9, 0.5):
            heights[f"{plan[0]} S = {plan[1]}"] = np.interp(1e-3 * heights["time_ms"], time, height)
        print(*rows[-1].values(), flush=True)
        with open(here / "measured.csv", "w", newline="") as file:
            table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            table.writeheader()
            table.writerows(rows)
    np.savetxt(here / "heights.csv", np.column_stack(list(heights.values())), fmt="%.4g", delimiter=",",
               header=",".join(heights), comments="")


if __name__ == "__main__":
    main()
