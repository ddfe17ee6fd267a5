#!/usr/bin/python3
"""Which share of the cells a daughter takes of which share of the flow; and tiny cells, held to the exact law.

    studies/phase-separation/study.py [--program build/release/tanktread] [--out results/phase-separation] [-j 1] [--quick]

Runs what is not there yet, then writes measured.csv, tiny.csv, shares.svg and verdict.md beside this file.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve  # noqa: E402
from sweep import Sweep  # noqa: E402

FLOW, PARENT, SECTION, BEYOND = 0.02, 20.0, 40.0, 100.0  # mm²/s, um; x of the parent's section and x surely behind the fork, um
SHARES = (0.2, 0.4, 0.3, 0.1, 0.5)  # of the flow, into the upper daughter
TINY, TINY_AT = (0.1, 0.2, 0.3, 0.4), 90.0  # of the flow; um: x in the parent at which their height is told
RUNGS = np.array([-1.4, -1.0, -0.6, -0.2, 0.2, 0.6, 1.0, 1.4])  # um above the height that parts, of tiny cells at the start


def describe(share):
    return f"share{share}", {"port.upper.flow_rate": f"{-share * FLOW:g} mm^2/s"}


def parting_height(share):
    """Height above the middle [um] where a parabola has this share of its flow above it: 3 n² − 2 n³, n from the wall in widths."""
    n = np.linspace(0.0, 1.0, 100001)
    return PARENT * (0.5 - float(np.interp(share, 3 * n**2 - 2 * n**3, n)))


def describe_tiny(share):
    """The faster ones, nearer the middle, go ahead: none meets another."""
    at = ", ".join(f'["{16 + 10 * k} um", "{parting_height(share) + rung:.3f} um"]' for k, rung in enumerate(RUNGS[::-1]))
    return f"tiny-share{share}", {
        "port.inlet.mean_velocity": "3 mm/s", "port.upper.flow_rate": f"{-share * 3 * FLOW:g} mm^2/s", "port.inlet.feed.hematocrit": "auto", "cells.hematocrit": "auto", "cells.layout": "explicit",
        "cells.positions": f"[{at}]", "cells.radius": "1 um", "cells.cytoplasm_viscosity": "1.2 cP", "membrane.hardening.apply_to": "[]",
        "membrane.shear_modulus": "6e-2 dyn/cm", "geometry.lengths": '["120 um", "100 um", "100 um"]', "numerics.dx": "0.25 um",
        "time.average_from": "auto", "numerics.dt": "auto", "time.end": "80 ms", "output.series": "0.5 ms"}


def ways(results, at, beyond, begin=0.0):
    """(height at x = `at` [um], 1 if it took the upper daughter) of each cell that passed there after `begin` and then the fork."""
    cells = results.cells
    found = []
    for cell in np.unique(cells["cell"]):
        mine = cells["cell"] == cell
        time, x, y = cells["time"][mine], 1e6 * cells["x"][mine], 1e6 * cells["y"][mine]
        if x[0] <= at and x[-1] > beyond:
            k = int(np.argmax(x > at))
            if k and time[k] >= begin:
                found.append((float(np.interp(at, x[k - 1:k + 1], y[k - 1:k + 1])), float(y[-1] > 0.0)))
    return np.array(found).reshape(-1, 2)


def streamline(results, share):
    """Height of the mean flow's dividing streamline in the parent [um]."""
    table = results.section_profiles
    parent = table["section"] == 0
    passed = np.cumsum(table["velocity"][parent])
    edges = 1e6 * table["place"][parent] + 0.5 * PARENT / parent.sum()
    return float(np.interp(1.0 - share, passed / passed[-1], edges)) - 0.5 * PARENT


def error_of_mean(values, batches=10):
    """The larger of the binomial error and that of the means of ten batches in order, as one cell's way hangs on those before it.

    The binomial one as if one more cell had gone each way: it is not zero where none did.
    """
    share = (values.sum() + 1.0) / (len(values) + 2.0)
    binomial = np.sqrt(share * (1.0 - share) / len(values))
    if len(values) < 2 * batches:
        return float(binomial)
    means = [batch.mean() for batch in np.array_split(values, batches)]
    return float(max(binomial, np.std(means, ddof=1) / np.sqrt(batches)))


def measure(share, results):
    fork = results.summary
    flow = fork["fork.upper_daughter.flow_fraction"]["value"]
    cells = ways(results, SECTION, BEYOND, fork["parent.flow_rate"]["window"][0])
    if not len(cells):
        cells = np.array([[0.0, 0.0]])
    by_streamline, went = (cells[:, 0] > streamline(results, flow)).astype(float), cells[:, 1]
    return {"held": share, "flow_share": round(flow, 4), "cells": len(cells), "cell_share": round(float(went.mean()), 4),
            "error": round(error_of_mean(went), 4), "pries": round(fork["fork.upper_daughter.pries_cell_fraction"]["value"], 4),
            "streamlines": round(float(by_streamline.mean()), 4), "drawn_in": int(np.sum((went == 1) & (by_streamline == 0))),
            "drawn_out": int(np.sum((went == 0) & (by_streamline == 1))),
            "hematocrit_feed_discharge": round(fork["parent.hematocrit_discharge"]["value"], 4)}


def measure_tiny(share, results):
    """Between which heights, above the one that parts a parabola, the ways part."""
    cells = ways(results, TINY_AT, 135.0)
    above = cells[:, 0] - parting_height(share)
    upper, lower = above[cells[:, 1] == 1], above[cells[:, 1] == 0]
    return {"flow_share": share, "parting_height_um": round(parting_height(share), 3), "cells": len(cells),
            "highest_that_went_down_um": round(float(max(lower, default=np.nan)), 3),
            "lowest_that_went_up_um": round(float(min(upper, default=np.nan)), 3)}


def verdict(rows, tiny):
    low = [row for row in rows if row["held"] < 0.45]
    def count(holds): return f"{sum(map(holds, low))} of {len(low)}"
    within = {name: sum(abs(row["cell_share"] - row[name]) < 2 * row["error"] for row in rows) for name in ("pries", "streamlines")}
    drawn_in, drawn_out = (sum(row[name] for row in low) for name in ("drawn_in", "drawn_out"))
    z = (drawn_in - drawn_out) / max(np.sqrt(drawn_in + drawn_out), 1.0)
    met = [row["flow_share"] for row in tiny if -0.5 < row["highest_that_went_down_um"] < row["lowest_that_went_up_um"] < 0.5]
    return (f"- Fewer cells than flow in the slower daughter: beyond two errors in {count(lambda r: r['flow_share'] - r['cell_share'] > 2 * r['error'])} splits.\n"
            f"- Pries' curve: within two errors of {within['pries']} of {len(rows)} splits. Cells gone as the plasma at their centre: {within['streamlines']}.\n"
            f"- Drawn to the slower daughter, across the dividing streamline: {drawn_in} cells, away from it {drawn_out} "
            f"({z:+.1f} errors): {'attraction to the slower one, as Doyeux et al.' if z > 2 else 'attraction to the faster one' if z < -2 else 'neither'}.\n"
            f"- Tiny cells part within 0.5 µm of the exact height: at {len(met)} of {len(tiny)} shares.\n")


def figure(sweep, rows):
    rows = sorted(rows, key=lambda row: row["flow_share"])
    column = {name: [row[name] for row in rows] for name in rows[0]}
    sweep.draw("shares", 'set xlabel "share of the flow"\nset ylabel "share of the cells"\nset xrange [0:0.6]\nset yrange [0:0.65]\nset key left top',
               [Curve("as the flow", "with lines linecolor 'gray60'", [[0, 0.6], [0, 0.6]]),
                Curve("Pries and Secomb", "with linespoints pointtype 0 linewidth 2", [column["flow_share"], column["pries"]]),
                Curve("if cells went as plasma", "with points pointtype 6", [column["flow_share"], column["streamlines"]]),
                Curve("measured", "with yerrorbars pointtype 7", [column["flow_share"], column["cell_share"], column["error"]])])


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__, quick={"numerics.dx": "0.6 um", "cells.radius": "2.5 um", "time.end": "18 ms", "time.average_from": "3 ms"})
    rows = sweep.tabulate(SHARES[-2:] if sweep.is_quick else SHARES, describe, measure)
    tiny = sweep.tabulate(TINY[-1:] if sweep.is_quick else TINY, describe_tiny, measure_tiny, "tiny.csv")
    figure(sweep, rows)
    (sweep.tables / "verdict.md").write_text(verdict(rows, tiny))
    print(verdict(rows, tiny), end="")
