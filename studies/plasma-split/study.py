#!/usr/bin/python3
"""How plasma alone parts at a fork, against the resistance law of flat channels.

    studies/plasma-split/study.py [--program build/release/tanktread] [--out results/plasma-split] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, split.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve  # noqa: E402
from sweep import Sweep  # noqa: E402

VISCOSITY, PARENT, BEFORE = 1.2e-3, 20.0, 40.0  # Pa s, um, um: width and length of the parent
#       shape, widths of upper and lower daughter [um], their lengths [um], angles [deg], dx [um]
FORKS = [("fork", (14, 9.2), (100, 100), (36, -36)), ("fork", (14, 9.2), (200, 200), (36, -36)), ("fork", (14, 9.2), (400, 400), (36, -36)),
         ("fork", (14, 9.2), (300, 150), (36, -36)), ("fork", (14, 9.2), (200, 200), (60, 0)), ("fork", (12, 12), (100, 100), (36, -36)),
         ("fork", (12, 12), (100, 300), (36, -36)), ("fork", (16, 8), (200, 200), (36, -36)), ("fork", (8, 16), (100, 400), (36, -36)),
         ("t-junction", (16, 12), (60, 60), None), ("t-junction", (16, 12), (120, 120), None), ("t-junction", (12, 12), (60, 180), None),
         ("t-junction", (12, 8), (80, 40), None)]
PLAN = [(*fork, 0.5) for fork in FORKS] + [(*FORKS[0], 0.25), (*FORKS[9], 0.25)]
NAMES = ("shape", "width_upper_um", "width_lower_um", "length_upper_um", "length_lower_um", "angles_deg", "dx_um")


def describe(item):
    shape, widths, lengths, angles, dx = item
    turned = {"geometry.angles": "[" + ", ".join(f'"{a} deg"' for a in angles) + "]"} if angles else {}
    return "-".join(str(part) for part in (shape, *widths, *lengths, *(angles or ()), f"dx{dx}")), {
        "geometry.shape": shape, **turned, "geometry.daughter_widths": "[" + ", ".join(f'"{w} um"' for w in widths) + "]",
        "geometry.lengths": "[" + ", ".join(f'"{length} um"' for length in (BEFORE, *lengths)) + "]", "numerics.dx": f"{dx} um"}


def conductance(width, length):
    """Of a flat channel, w³/(12 mu L) [m²/(Pa s)], both in um."""
    return 1e-12 * width**3 / (12.0 * VISCOSITY * length)


def share(widths, lengths, end=0.0):
    """Of the flow, into the upper daughter: by the law, with each daughter longer by `end` of its widths."""
    upper, lower = (conductance(w, length + end * w) for w, length in zip(widths, lengths))
    return upper / (upper + lower)


def measure(item, results):
    shape, widths, lengths, angles, dx = item
    ports = results.ports
    upper, lower = (-ports[f"{name}.flow_rate"] for name in ("upper", "lower"))
    seen = upper / (upper + lower)
    drop = 1.0 / sum(conductance(w, length) for w, length in zip(widths, lengths)) + 1.0 / conductance(PARENT, BEFORE)
    return {**dict(zip(NAMES, (shape, *widths, *lengths, "{} {}".format(*angles) if angles else "90 -90", dx))),
            "share": round(float(seen[-1]), 5), "law": round(share(widths, lengths), 5),
            "moved_in_last_tenth": float(f"{abs(seen[-1] - seen[-2]):.1g}"),
            "resistance_over_law": round(float(ports["inlet.pressure"][-1] / ports["inlet.flow_rate"][-1] / drop), 4)}


def sizes(row):
    return tuple((row[f"{kind}_upper_um"], row[f"{kind}_lower_um"]) for kind in ("width", "length"))


def off(row, end=0.0):
    """Share minus that of the law."""
    return row["share"] - share(*sizes(row), end)


def slenderness(row):
    """Length over width of the daughter that is least slender."""
    return min(length / width for width, length in zip(*sizes(row)))


def end_length(rows):
    """The one `end` for all forks that leaves the least squares."""
    ends = np.linspace(-2.0, 2.0, 2001)
    return float(ends[np.argmin([sum(off(row, end) ** 2 for row in rows) for end in ends])])


def verdict(rows):
    """Holds where the law alone is within 0.01 of every share whose daughters are ten widths long or longer."""
    coarse = [row for row in rows if row["dx_um"] == PLAN[0][-1]]
    long, short = ([row for row in coarse if (slenderness(row) >= 10.0) == wanted] for wanted in (True, False))
    worst = {name: max(abs(off(row)) for row in some) for name, some in (("long", long), ("short", short))}
    end = end_length(coarse)
    left = max(abs(off(row, end)) for row in coarse)
    grid = max(abs(fine["share"] - row["share"]) for fine in rows[len(coarse):] for row in coarse if sizes(row) == sizes(fine)
               and row["shape"] == fine["shape"] and row["angles_deg"] == fine["angles_deg"])
    return (f"{'holds' if worst['long'] < 0.01 else 'does not hold'}: the share is within {worst['long']:.4f} of the law in the {len(long)} "
            f"forks with daughters of ten widths and more. It is within {worst['short']:.4f} in the {len(short)} shorter ones. With one "
            f"end length for all, {end:+.2f} widths a daughter, within {left:.4f}. Half the spacing moves a share by up to {grid:.4f}.\n")


def figure(sweep, rows):
    kinds = [("forks", "fork", 7), ("T junctions", "t-junction", 5)]
    curves = [Curve(title, f"with points pointtype {mark}", [[slenderness(row) for row in rows if row["shape"] == shape],
                                                              [off(row) for row in rows if row["shape"] == shape]])
              for title, shape, mark in kinds]
    sweep.draw("split", 'set xlabel "length over width of the stubbier daughter"\nset ylabel "share of the upper daughter, minus the law\'s"\n'
               "set xzeroaxis\nset xrange [0:*]", curves)


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "1 um", "time.end": "1 ms", "output.series": "0.5 ms", "output.frames": "1 ms"})
    rows = sweep.tabulate(PLAN[:2] + PLAN[9:10] + PLAN[13:] if sweep.is_quick else PLAN, describe, measure)
    figure(sweep, rows)
    (sweep.tables / "verdict.md").write_text(verdict(rows))
    print(verdict(rows), end="")
