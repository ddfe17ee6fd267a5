#!/usr/bin/python3
"""What the time step, the density scale S, the relaxation time and the equilibrium do to a result.

    studies/time-step/study.py [--program build/release/tanktread] [--out results/time-step] [-j 1] [--jobs 1]

Runs what is not there yet (some twenty minutes on one core), then writes measured.csv beside this file; `limits.py` makes the
table of limits and the figure of it.
"""
import dataclasses
import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import SHEAR_RATE_OF_G  # noqa: E402
from sweep import Sweep, mean_of  # noqa: E402

VISCOSITY, DENSITY, MODULUS, RADIUS = 1.2e-3, 1025.0, 6e-6, 4e-6  # SI
STRAINED = {0.05: (14, 11), 0.2: (20, 16), 0.5: (27, 22)}  # k t at the end, and from where averages are taken


@dataclasses.dataclass(frozen=True)
class Item:
    scene: str  # shear | row | lanes | channel
    at: float  # G in shear, else pseudo-shear rate [/s]
    equilibrium: str
    scale: float  # S
    tau: float = 1.5  # of the plasma
    dx: float = 0.5  # um
    seed: int = 1  # of the scene channel

    @property
    def rate(self) -> float:
        return SHEAR_RATE_OF_G * self.at if self.scene == "shear" else self.at

    @property
    def step(self) -> float:
        """dt [s], by nu = mu/(S rho) = (tau - 1/2)/3 dx²/dt."""
        return (self.tau - 0.5) * self.scale * (self.dx * 1e-6) ** 2 * DENSITY / (3.0 * VISCOSITY)


def shear(item):
    end, start = (k_t / item.rate for k_t in STRAINED[item.at])
    return "03-cell-in-shear", {"flow.shear_number": item.at, "time.end": f"{1e3 * end:.6g} ms",
                                "time.average_from": f"{1e3 * start:.6g} ms", "output.frames": f"{1e3 * end:.6g} ms"}


BOXES = {  # 16 um of the channel. row: one cell off the middle, on its way there; lanes: two, one nearer to either wall
    "row": {"cells.count": 1, "cells.positions": '[["8 um", "6.5 um"]]'},
    "lanes": {"cells.count": 2, "cells.positions": '[["4 um", "5.5 um"], ["12 um", "14 um"]]'}}


def channel(item):
    """Case III of the paper for 5 transits of its channel (k t = 20); with all twelve cells, for ten."""
    box = BOXES.get(item.scene)
    keys = {"domain.length": "16 um", "cells.layout": "explicit", **box} if box else {"cells.seed": item.seed}
    end = (20 if box else 40) / item.rate * 1e3
    return "05-channel", {**keys, "flow.pseudo_shear_rate": f"{item.at:g} /s", "time.end": f"{end:.6g} ms",
                          "time.average_from": f"{end / 2:.6g} ms", "output.series": f"{end / 400:.6g} ms",
                          "output.frames": f"{end:.6g} ms"}


def describe(item):
    case, keys = (shear if item.scene == "shear" else channel)(item)
    keys |= {"numerics.dx": f"{item.dx} um", "numerics.relaxation_time": item.tau, "numerics.density_scale": f"{item.scale:.8g}",
             "numerics.equilibrium": item.equilibrium}
    name = f"{item.scene}-{item.at:g}-{item.equilibrium}-S{item.scale:g}-tau{item.tau:g}-dx{item.dx:g}"
    return name + (f"-seed{item.seed}" if item.scene == "channel" else ""), keys, case


def measure(item, results):
    speed = (0.5 * 40 if item.scene == "shear" else 1.5 * 20) * 1e-6 * item.rate
    row = {"scene": item.scene, "at": item.at, "equilibrium": item.equilibrium, "dx_um": item.dx, "seed": item.seed,
           "scale": item.scale, "tau": item.tau, "dt_us": round(1e6 * item.step, 5),
           "reynolds": round(item.scale * DENSITY * item.rate * RADIUS**2 / VISCOSITY, 6),
           "mach": round(math.sqrt(3.0) * speed * item.step / (item.dx * 1e-6), 6),
           "tension_number": round(3.0 * MODULUS * item.step / (VISCOSITY * item.dx * 1e-6), 6),
           "k_dt": round(item.rate * item.step, 8)}
    quantities = {"D": "taylor_inertia", "strain": "strain", "inclination_deg": "inclination_deg", "kT": "tank_treading_kT",
                  "mu_rel": "mu_rel"}
    for name, key in quantities.items():
        row[name] = round(mean_of(results, key), 6) if results else float("nan")
    for k_t in (1, 4):  # on the way
        row[f"strain_at_kt{k_t}"] = (round(float(np.interp(k_t / item.rate, results.series["time"], results.series["strain"])), 6)
                                     if results else float("nan"))
    row["height_um"] = round(1e6 * float(results.cells.of_cell(0)["y"][-1]), 4) if results else float("nan")
    return row


def series(scene, at, equilibrium, scales, tau=1.5, **more):
    return [Item(scene, at, equilibrium, scale, tau, **more) for scale in scales]


def plan():
    halved = [7, 14, 28, 56, 112, 224]
    items = [item for e in ("linear", "incompressible", "full") for item in series("shear", 0.2, e, halved)]
    # S alone, dt and with it Mach and tension number fixed; then dt alone, S fixed: both through tau
    items += [Item("shear", 0.2, "linear", 56 / (tau - 0.5), tau) for tau in (0.75, 1.0, 2.5, 4.5, 8.5)]
    items += [Item("shear", 0.2, "linear", 28, tau) for tau in (0.75, 1.0, 2.5, 4.5, 8.5)]
    items += series("shear", 0.05, "linear", [29, 58, 117, 234, 350]) + series("shear", 0.05, "incompressible", [29, 58, 117, 234, 350])
    for scene in ("row", "lanes"):
        for rate, scales in ((50, [14, 29, 58, 117, 234, 350]), (150, [7, 14, 28, 56, 112, 224]), (500, [1.75, 3.5, 7, 14, 28, 44, 66])):
            for equilibrium in ("incompressible", "linear"):
                items += series(scene, rate, equilibrium, scales)
            scale = scales[2]
            items += [Item(scene, rate, "incompressible", scale, tau) for tau in (0.75, 1.0, 2.5, 4.5)]
            items += [Item(scene, rate, "incompressible", scale / (tau - 0.5), tau) for tau in (0.75, 1.0, 2.5)]
        items += series(scene, 500, "full", [1.75, 3.5, 7, 14, 28, 44, 66])
    return items


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    sweep.tabulate(plan(), describe, measure)
