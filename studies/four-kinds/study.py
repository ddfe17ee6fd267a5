#!/usr/bin/python3
"""A hundred cells of four kinds, ten times through a channel: are all there at the end, do any overlap, what does each kind do.

    studies/four-kinds/study.py [--program build/release/tanktread] [--out results/four-kinds] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, cells.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, wrapped_outline  # noqa: E402
from sweep import Sweep  # noqa: E402

KINDS = ("red", "stiff", "white", "platelet")
LENGTH, WIDTH, COLOURS = 87.0, 60.0, ("#b03030", "#e0a000", "#3060b0", "#208050")  # um, um


def measure(results, name, number):
    """Of one kind; means over the second half."""
    cells = results.cells
    mine = cells["kind"] == number
    time, y = cells["time"], 1e6 * cells["y"]
    late, first, last = (mine & chosen for chosen in (time >= 0.5 * time[-1], time == time[0], time == time[-1]))
    centre = np.minimum(y, WIDTH - y)
    drift = {cell: cells["area"][mine & (cells["cell"] == cell)] for cell in np.unique(cells["cell"][mine])}
    return {"kind": name, "cells_start": int(first.sum()), "cells_end": int(last.sum()),
            "centre_start_um": round(float(centre[first].mean()), 2), "centre_um": round(float(centre[late].mean()), 2),
            "gap_um": round(float(1e6 * cells["wall_distance"][late].mean()), 2),
            "velocity_mm_per_s": round(float(1e3 * cells["velocity"][late].mean()), 3),
            "lambda_C": round(float(cells["lambda_C"][late].mean()), 4),
            "taylor_deformation": round(float(np.nanmean(cells["taylor_inertia"][late])), 3),
            "area_drift": float(f"{max(np.abs(area / area[0] - 1.0).max() for area in drift.values()):.1e}")}


def verdict(results, rows):
    series = results.series
    way = float(np.trapz(series["mean_velocity"], series["time"])) / (1e-6 * LENGTH)
    gaps = series["smallest_gap"][np.isfinite(series["smallest_gap"])]
    start, end = (sum(row[f"cells_{at}"] for row in rows) for at in ("start", "end"))
    return (f"- Cells: {start} at the start, {end} at the end, of each kind as many; {way:.2f} lengths of the channel at the mean velocity.\n"
            f"- Overlap: at most {int(series['overlaps'].max())} nodes inside another cell, at any of {len(series['time'])} times; "
            f"smallest gap {1e6 * gaps.min():.2f} µm, {gaps.min() / results.grid['dx']:.2f} sites.\n"
            f"- Area: largest drift of any cell {max(row['area_drift'] for row in rows):.1e}.\n"
            if start == end and all(row["cells_start"] == row["cells_end"] for row in rows) else f"- Cells lost: {start} at the start, {end} at the end.\n")


def figure(sweep, results):
    frame = results.frame(-1)
    curves = []
    for number, name in enumerate(KINDS):
        pieces = [piece for cell in range(frame.cell_count) if frame.kind[cell] == number for piece in wrapped_outline(frame.outline(cell), 1e-6 * LENGTH)]
        curves.append(Curve(name, f"with lines linewidth 1.5 linecolor '{COLOURS[number]}'", list(np.vstack(pieces).T)))
    sweep.draw("cells", f'set size ratio -1\nset xrange [0:{LENGTH}]\nset yrange [0:{WIDTH}]\nset xlabel "x [µm]"\nset ylabel "y [µm]"\n'
               'set key outside top center horizontal', curves, size=(620, 480))


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "0.3 um", "numerics.step_tolerance": "5 %", "time.end": "2 ms", "output.series": "0.1 ms"})
    results = sweep.run("all", {})
    if results is None:
        raise SystemExit("the run became unstable")
    rows = [measure(results, name, number) for number, name in enumerate(KINDS)]
    sweep.write("measured.csv", rows)
    figure(sweep, results)
    (sweep.tables / "verdict.md").write_text(verdict(results, rows))
    for row in rows:
        print(*row.values())
    print(verdict(results, rows), end="")
