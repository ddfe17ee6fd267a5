#!/usr/bin/python3
"""What the time step, the density scale S, the relaxation time and the equilibrium do to a result.

    studies/time-step/study.py [--program build/release/tanktread] [--out results/time-step] [-j 1] [--jobs 1]

Runs what is not there yet (some twenty minutes on one core), then writes measured.csv, table.md and two figures beside this
file.
"""
import dataclasses
import math
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve  # noqa: E402
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
    ratio: float = 5  # of the viscosities

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
             "numerics.equilibrium": item.equilibrium, "cells.cytoplasm_viscosity": f"{1.2 * item.ratio:g} cP"}
    name = f"{item.scene}-{item.at:g}-{item.equilibrium}-S{item.scale:g}-tau{item.tau:g}-dx{item.dx:g}"
    name += f"-ratio{item.ratio:g}" if item.ratio != 5 else ""
    return name + (f"-seed{item.seed}" if item.scene == "channel" else ""), keys, case


def measure(item, results):
    speed = (0.5 * 40 if item.scene == "shear" else 1.5 * 20) * 1e-6 * item.rate
    row = {"scene": item.scene, "at": item.at, "equilibrium": item.equilibrium, "ratio": item.ratio, "dx_um": item.dx,
           "seed": item.seed,
           "scale": item.scale, "tau": item.tau, "dt_us": round(1e6 * item.step, 5),
           "reynolds": round(item.scale * DENSITY * item.rate * RADIUS**2 / VISCOSITY, 6),
           "mach": round(math.sqrt(3.0) * speed * item.step / (item.dx * 1e-6), 6),
           "tension_number": round(3.0 * MODULUS * item.step / (VISCOSITY * item.dx * 1e-6), 6),
           "k_dt": round(item.rate * item.step, 8), "delay": round((item.tau - 0.5) * speed * item.step / RADIUS, 8)}
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
    # what of it is due to the two viscosities; the grid
    for ratio, dx in ((1, 0.5), (5, 0.25)):
        items += [Item("row", 150, "incompressible", scale, tau, dx=dx, ratio=ratio)
                  for scale, tau in ((14, 1.5), (28, 0.75), (28, 1.5), (28, 2.5), (28, 4.5))]
    # twelve cells, where chance has its part
    for seed in (1, 2, 3):
        items += series("channel", 50, "incompressible", (293, 100), dx=0.4, seed=seed)
    for seed in (1, 2):
        items += series("channel", 50, "linear", (293, 100), dx=0.4, seed=seed)
        items += series("channel", 500, "incompressible", (26, 5), dx=0.5, seed=seed)
    return items


def groups(rows):
    """The rows of one scene, rate, equilibrium, ratio and grid together, in which only S and tau differ."""
    found: dict = {}
    for row in rows:
        if row["scene"] != "channel":
            found.setdefault(tuple(row[key] for key in ("scene", "at", "equilibrium", "ratio", "dx_um")), []).append(row)
    return found


def fit(rows, quantity, along):
    """Least squares of quantity = q0 (1 + sum of c x) over the numbers `along`; q0, the c, and the largest misfit over q0.

    Only where the changes are still small: Re up to 0.25, delays up to 0.01; along Re alone, the three smallest.
    """
    rows = [row for row in rows if row["reynolds"] < 0.25 and row["delay"] < 0.01 and math.isfinite(row[quantity])]
    if len(along) == 1:
        rows = sorted((row for row in rows if row["tau"] == 1.5), key=lambda row: row["reynolds"])[:3]
    matrix = np.array([[1.0, *(row[x] for x in along)] for row in rows])
    values = np.array([row[quantity] for row in rows])
    solution = np.linalg.lstsq(matrix, values, rcond=None)[0]
    return solution[0], solution[1:] / solution[0], np.abs(matrix @ solution - values).max() / solution[0]


def table(rows):
    head = ("scene", "G or rate", "equilibrium", "ratio", "h [µm]", *(f"{name}: Re, delay" for name in ("D", "ε", "kT", "λ_C", "μ_rel")),
            "misfit of ε", "ε at k t = 4: Re")
    lines = [head, ("---",) * len(head)]
    for (scene, at, equilibrium, ratio, dx), mine in groups(rows).items():
        along = ("reynolds", "delay") if len({row["tau"] for row in mine}) > 1 and scene != "shear" else ("reynolds",)
        if len({row["scale"] for row in mine}) < 3:
            continue
        fits = {name: fit(mine, name, along) for name in ("D", "strain", "kT", "mu_rel", "strain_at_kt4")}
        base, slopes, misfit = fits["strain"]
        fits["lambda_C"] = base, slopes * base / (1.0 + base), misfit
        lines.append((scene, f"{at:g}", equilibrium, f"{ratio:g}", f"{dx:g}",
                      *(", ".join(f"{c:+.3g}" for c in fits[name][1]) for name in ("D", "strain", "kT", "lambda_C", "mu_rel")),
                      f"{100 * misfit:.2f} %", f"{fits['strain_at_kt4'][1][0]:+.3g}"))
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def chance_table(rows):
    """Twelve cells: mean over the seeds and its standard error."""
    rows = [row for row in rows if row["scene"] == "channel"]
    lines = [("rate", "equilibrium", "S", "Re", "seeds", "λ_C", "μ_rel"), ("---",) * 7]
    for key in dict.fromkeys((row["at"], row["equilibrium"], row["scale"]) for row in rows):
        mine = [row for row in rows if (row["at"], row["equilibrium"], row["scale"]) == key and math.isfinite(row["mu_rel"])]
        if len(mine) < 2:
            continue
        texts = []
        for values in (np.array([1.0 + row["strain"] for row in mine]), np.array([row["mu_rel"] for row in mine])):
            texts.append(f"{values.mean():.4f} ± {values.std(ddof=1) / math.sqrt(len(values)):.4f}")
        lines.append((f"{key[0]:g} /s", key[1], f"{key[2]:g}", f"{mine[0]['reynolds']:.3f}", str(len(mine)), *texts))
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def curve(title, style, rows, quantity, along, keep):
    """|change| of a quantity against a number, from what the fit gives at zero."""
    zero = fit(rows, quantity, along)[0]
    mine = sorted((row for row in rows if keep(row) and math.isfinite(row[quantity])), key=lambda row: row[along[0]])
    return Curve(title, style, [[row[along[0]] for row in mine], [abs(100.0 * (row[quantity] / zero - 1.0)) for row in mine]])


def figures(sweep, rows):
    of, both, style = groups(rows), ("reynolds", "delay"), "with linespoints linetype {} pointtype {}"
    main_tau = lambda row: row["tau"] == 1.5  # noqa: E731
    curves = [curve("shear G = 0.05, linear, ε at k t = 4", style.format(1, 7), of["shear", 0.05, "linear", 5, 0.5],
                    "strain_at_kt4", ("reynolds",), main_tau),
              curve("shear G = 0.2, incompressible, ε", style.format(2, 7), of["shear", 0.2, "incompressible", 5, 0.5], "strain",
                    ("reynolds",), main_tau),
              curve("row 50 /s, linear, ε", style.format(5, 7), of["row", 50, "linear", 5, 0.5], "strain", ("reynolds",), main_tau)]
    for k, (rate, at) in enumerate(((50, 3), (150, 4), (500, 6))):
        mine = of["row", rate, "incompressible", 5, 0.5]
        curves.append(curve(f"row {rate} /s, incompressible, ε", style.format(at, 5), mine, "strain", both, lambda row: row["tau"] == 0.75))
        curves.append(curve(f"row {rate} /s, incompressible, μ_{{rel}}", style.format(at, 4) + " dashtype 2", mine, "mu_rel", both,
                            lambda row: row["tau"] == 0.75))
    curves.append(Curve("1 %", "with lines linetype 7 dashtype 3", [[0.01, 0.8], [1.0, 1.0]]))
    sweep.draw("reynolds", 'set logscale xy\nset xlabel "S ρ k a^2/μ"\nset ylabel "change [%]"\nset key outside right\n'
               'set yrange [0.05:100]\nset xrange [0.005:1]', curves, (860, 420))
    curves = []
    for k, (scene, rate, ratio, dx) in enumerate((("row", 50, 5, 0.5), ("row", 150, 5, 0.5), ("row", 150, 5, 0.25), ("row", 150, 1, 0.5),
                                                  ("row", 500, 5, 0.5), ("lanes", 150, 5, 0.5), ("lanes", 500, 5, 0.5))):
        mine = of[scene, rate, "incompressible", ratio, dx]
        zero, slopes, _ = fit(mine, "strain", both)
        shown = sorted((row for row in mine if row["delay"] > 2e-4 and math.isfinite(row["strain"])), key=lambda row: row["delay"])
        curves.append(Curve(f"{scene} {rate} /s, ratio {ratio}, h = {dx} µm", f"with points linetype {1 + k} pointtype {4 + k}",
                            [[row["delay"] for row in shown],
                             [-100.0 * (row["strain"] / zero - 1.0 - slopes[0] * row["reynolds"]) for row in shown]]))
    curves.append(Curve("1 %", "with lines linetype 7 dashtype 3", [[2e-4, 0.05], [1.0, 1.0]]))
    sweep.draw("delay", 'set logscale xy\nset xlabel "(τ - 1/2) V dt/a"\nset ylabel "change of ε without that of Re [%]"\n'
               'set key outside right', curves, (860, 420))


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    rows = sweep.tabulate(plan(), describe, measure)
    (sweep.here / "table.md").write_text(table(rows) + "\n" + chance_table(rows))
    figures(sweep, rows)
