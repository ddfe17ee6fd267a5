#!/usr/bin/python3
"""What single precision of the sites' fields does to a result, held against a tenth of the tolerance of 1 %.

    studies/precision/study.py [--program build/release/tanktread] [--out results/precision] [-j 1] [--jobs 1]

Runs what is not there yet (some minutes on one core), then writes measured.csv and table.md beside this file.
"""
import dataclasses
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from sweep import Sweep, mean_of  # noqa: E402

TENTH_OF_TOLERANCE = 1e-3  # of the default numerics.step_tolerance
COMMON = {"numerics.dx": "0.5 um", "output.frames": "1 s"}
BOX = {"domain.length": "16 um", "cells.layout": "explicit"}
ROW = {**BOX, "cells.count": 1, "cells.positions": '[["8 um", "6.5 um"]]'}
LANES = {**BOX, "cells.count": 2, "cells.positions": '[["4 um", "5.5 um"], ["12 um", "14 um"]]'}


def times(end_ms):
    """The second half is averaged."""
    return {"time.end": f"{end_ms:g} ms", "time.average_from": f"{end_ms / 2:g} ms", "output.series": f"{end_ms / 400:g} ms"}


def channel(rate, **keys):
    return "05-channel", {"flow.pseudo_shear_rate": f"{rate} /s", **keys}


SCENES = {  # of one cell in shear, one and two in a box of the channel for k t = 20, and all twelve for three transits
    "shear, G = 0.2": ("03-cell-in-shear", {"flow.shear_number": 0.2}),
    "row, 50 /s": channel(50, **ROW, **times(400)),
    "row, 500 /s": channel(500, **ROW, **times(40)),
    "lanes, 500 /s": channel(500, **LANES, **times(40)),
    "channel, 500 /s, three transits": channel(500, **times(24)),
}
QUANTITIES = {"D": "taylor_inertia", "strain": "strain", "lambda_C": "lambda_C", "mu_rel": "mu_rel"}


@dataclasses.dataclass(frozen=True)
class Item:
    scene: str
    precision: str


def describe(item):
    case, keys = SCENES[item.scene]
    name = "".join(letter if letter.isalnum() else "-" for letter in item.scene)
    return f"{name}-{item.precision}", {**COMMON, **keys, "numerics.precision": item.precision}, case


def measure(item, results):
    return {"scene": item.scene, "precision": item.precision,
            **{name: f"{mean_of(results, key):.9g}" for name, key in QUANTITIES.items()}}


def table(rows):
    lines = [("scene", *(f"{name}: double, change" for name in QUANTITIES)), ("---",) * (1 + len(QUANTITIES))]
    largest = 0.0
    for scene in SCENES:
        exact, rounded = (next(row for row in rows if (row["scene"], row["precision"]) == (scene, precision))
                          for precision in ("double", "single"))
        changes = {name: float(rounded[name]) / float(exact[name]) - 1.0 for name in QUANTITIES}
        largest = max(largest, *map(abs, changes.values()))
        lines.append((scene, *(f"{float(exact[name]):.6g}, {changes[name]:+.1e}" for name in QUANTITIES)))
    lines = "".join("| " + " | ".join(line) + " |\n" for line in lines)
    verdict = "less" if largest < TENTH_OF_TOLERANCE else "NOT less"
    return lines + f"\nThe largest change is {largest:.1e}: {verdict} than {TENTH_OF_TOLERANCE:g}.\n"


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    rows = sweep.tabulate([Item(scene, precision) for scene in SCENES for precision in ("double", "single")], describe, measure)
    (sweep.here / "table.md").write_text(table(rows))
