#!/usr/bin/python3
"""A neo-Hookean cell and a 2D-LD cell on the corner of a fork: which one becomes a noodle?

    studies/noodles/study.py [--program build/release/tanktread] [--out results/noodles] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, corner.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, Results, status_of  # noqa: E402
from sweep import Sweep  # noqa: E402

HARDENED = {"neo-Hookean": "[]", "2D-LD": '["shear", "bending", "area", "contact"]'}
NOODLE = 2.0  # lambda_C beyond which a cell is one, as in studies/profiles
WAY = 170.0  # um: past the fork; the middle line is 170 um long
BEHIND = 95.0  # um: x of a cell that has left the corner behind; near the port forces fade
#        mean velocity of the parent [mm/s], start above the middle line [um], dx [um], density scale
SPEEDS = ((1, 0.5, 0.4, "auto"), (3, 0.5, 0.4, "auto"), (10, 0.5, 0.4, "auto"))
CHECKS = ((3, 2.0, 0.4, "auto"), (3, 0.5, 0.25, "auto"), (3, 0.5, 0.4, 10))
PLAN = [(law, *rest) for rest in SPEEDS + CHECKS for law in HARDENED]


def describe(item):
    law, speed, start, dx, scale = item
    return f"{law}-{speed}-from{start}-dx{dx}" + f"-S{scale}" * (scale != "auto"), {
        **({} if scale == "auto" else {"numerics.density_scale": scale}),
        "membrane.hardening.apply_to": HARDENED[law], "port.inlet.mean_velocity": f"{speed} mm/s",
        "cells.positions": f'[["20 um", "{start} um"]]', "numerics.dx": f"{dx} um", "time.end": f"{WAY / speed:.3g} ms",
        "output.series": f"{1.0 / speed:.3g} ms", "output.frames": f"{3.0 / speed:.3g} ms"}


def measure(item, directory):
    """Until the cell is past the corner; of a run that became unstable, up to there."""
    law, speed, start, dx, scale = item
    cells = Results(directory).cells
    end = cells["time"][-1]
    cells = cells.where(1e6 * cells["x"] < BEHIND)
    longest = int(np.argmax(cells["lambda_C"]))
    return {"law": law, "speed_mm_per_s": speed, "start_um": start, "dx_um": dx, "density_scale": scale, "ending": status_of(directory),
            "lambda_C_max": round(float(cells["lambda_C"][longest]), 3), "at_ms": round(1e3 * float(cells["time"][longest]), 2),
            "x_um": round(1e6 * float(cells["x"][longest]), 1), "y_um": round(1e6 * float(cells["y"][longest]), 1),
            "stretch_max": round(float(cells["stretch_max"].max()), 3), "end_ms": round(1e3 * float(end), 2),
            "area_error": float(f"{cells['area_error'].max():.2g}")}


def panel(directory, column, row):
    """Walls, outlines every few frames, and the longest outline, moved to a place of their own."""
    frames = [frame for frame in Results(directory).frames() if frame.cell_count]
    left, right = 45.0, BEHIND
    shift = np.array([column * 55.0 - left, -row * 50.0])
    middle = 1e6 * 0.5 * float(frames[0].box[1])

    def moved(points):
        line = np.vstack([points, points[:1]]) * 1e6 - [0.0, middle]
        inside = (line[:, 0] > left) & (line[:, 0] < right) & (np.abs(line[:, 1]) < 23.0)
        return np.where(inside[:, None], line + shift, np.nan)

    outlines = [frame.outline(0) for frame in frames]
    length = [np.linalg.norm(np.roll(o, -1, axis=0) - o, axis=1).sum() * (1e6 * o[:, 0].mean() < BEHIND) for o in outlines]
    gap = [[np.nan, np.nan]]
    walls = [np.vstack([moved(refined(wall)), gap]) for wall in frames[0].walls]
    return walls, [np.vstack([moved(o), gap]) for o in outlines[::3]], [moved(outlines[int(np.argmax(length))]), gap]


def refined(loop, step=0.2e-6):
    """A loop with points close enough that a panel may cut it anywhere."""
    return np.vstack([a + (b - a) * np.linspace(0, 1, 2 + int(np.linalg.norm(b - a) / step))[:-1, None]
                      for a, b in zip(loop, np.roll(loop, -1, axis=0))])


def columns(lines):
    """x and y of all lines; one row of nan between two, as two end a block of gnuplot's."""
    rows = np.vstack(lines)
    gap = np.isnan(rows[:, 0])
    return list(rows[~(gap & np.roll(gap, 1))].T)


def figure(sweep):
    walls, outlines, longest = [], [], []
    for row, law in enumerate(HARDENED):
        for column, rest in enumerate(SPEEDS):
            for into, lines in zip((walls, outlines, longest), panel(sweep.given.out / describe((law, *rest))[0], column, row)):
                into += lines
    labels = [f'set label "{law}" at -4,{-50 * row} rotate by 90 center' for row, law in enumerate(HARDENED)]
    labels += [f'set label "{rest[0]} mm/s" at {25 + 55 * column},27 center' for column, rest in enumerate(SPEEDS)]
    sweep.draw("corner", "\n".join(["unset border", "unset tics", "set size ratio -1", "set xrange [-8:165]", "set yrange [-76:32]", "unset key",
                                    *labels]),
               [Curve("walls", "with lines linecolor 'black'", columns(walls)),
                Curve("cells", "with lines linecolor 'gray60'", columns(outlines)),
                Curve("longest", "with lines linewidth 2 linecolor 'red'", columns(longest))], size=(760, 480))


def verdict(rows):
    """Holds where at some speed every neo-Hookean cell passes NOODLE and at no speed a 2D-LD cell does."""
    most = {law: max(row["lambda_C_max"] for row in rows if row["law"] == law) for law in HARDENED}
    at = {law: [f"{row['speed_mm_per_s']} mm/s" for row in rows[:2 * len(SPEEDS)] if row["law"] == law and row["lambda_C_max"] > NOODLE]
          for law in HARDENED}
    shown = bool(at["neo-Hookean"]) and most["2D-LD"] < NOODLE
    return (f"{'shown' if shown else 'not shown'}. Beyond λ_C = {NOODLE:g} are "
            + ". ".join(f"{law} cells at {', '.join(at[law]) or 'no speed'} (longest {most[law]:.2f})" for law in HARDENED) + ".\n")


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "1 um", "cells.positions": '[["55 um", "0.5 um"]]', "time.end": "2 ms",
                                            "output.series": "0.2 ms", "output.frames": "0.2 ms"})
    plan = PLAN[:2 * len(SPEEDS)] if sweep.is_quick else PLAN
    rows = sweep.tabulate(plan, describe, lambda item, _: measure(item, sweep.given.out / describe(item)[0]))
    figure(sweep)
    (sweep.tables / "verdict.md").write_text(verdict(rows))
    print(verdict(rows), end="")
