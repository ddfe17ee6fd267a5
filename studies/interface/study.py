#!/usr/bin/python3
"""Candidates for the viscosity at a membrane: error of a cell in shear against the exact solution, order, cost.

    studies/interface/study.py [--program build/release/tanktread] [--out results/interface] [-j 1] [--jobs 1]

Runs what is not there yet (about half an hour on one core), then writes measured.csv, table.md and interface.svg beside this file.
"""
import dataclasses
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import Curve, read_reference  # noqa: E402
from runs import SHEAR_RATE_OF_G  # noqa: E402
from sweep import Sweep, mean_of  # noqa: E402

RATIO, SHEAR_NUMBER = 5, 0.2
STRAINED = {0.05: (14, 11), 0.2: (20, 16), 0.5: (27, 22)}  # k t at the end, and from where averages are taken
SPACINGS = (0.5, 1 / 3, 0.25)  # um: 8, 12 and 16 sites a radius; 0.2 um: 20
QUANTITIES = {"D": "taylor_inertia", "strain": "strain", "kT": "tank_treading_kT", "inclination_deg": "inclination_deg"}


@dataclasses.dataclass(frozen=True)
class Candidate:
    interface: str = "area-fraction"
    mean: str = "harmonic"
    corrected: bool = True
    kernel: str = "peskin4"

    @property
    def name(self) -> str:
        mean = "" if self.interface == "sharp" else f" {self.mean}"
        return f"{self.interface}{mean}{', corrected' * self.corrected}{f', {self.kernel}' * (self.kernel != 'peskin4')}"


WAYS = [Candidate(interface, mean, corrected) for corrected in (True, False)
        for interface, mean in (("area-fraction", "harmonic"), ("area-fraction", "arithmetic"), ("smoothed", "harmonic"),
                                ("smoothed", "arithmetic"), ("sharp", "harmonic"))]
KERNELS = [Candidate(kernel=kernel) for kernel in ("cosine4", "roma3")]
CANDIDATES = WAYS + KERNELS
FINEST = (WAYS[0], WAYS[1])  # at 0.2 um too


def describe(item):
    candidate, dx, shear_number = item
    end, start = (1e3 * k_t / (SHEAR_RATE_OF_G * shear_number) for k_t in STRAINED[shear_number])
    keys = {"flow.shear_number": shear_number, "time.end": f"{end:g} ms", "time.average_from": f"{start:g} ms", "numerics.dx": f"{dx:.12g} um", "numerics.interface_viscosity": candidate.interface,
            "numerics.viscosity_mean": candidate.mean, "numerics.jump_correction": str(candidate.corrected).lower(),
            "numerics.delta": candidate.kernel, "numerics.density_scale": f"{35.2 / shear_number:g}", "output.frames": f"{end:g} ms"}
    return f"{candidate.name.replace(', ', '-').replace(' ', '-')}-{dx:.4g}-G{shear_number:g}", keys, "03-cell-in-shear"


def exact(shear_number):
    for row in read_reference("capsule_shear_channel40.csv"):
        if float(row["viscosity_ratio"]) == RATIO and float(row["G"]) == shear_number:
            return {"D": float(row["D_inertia"]), **{name: float(row[name]) for name in ("strain", "kT", "inclination_deg")}}


def measure(item, results):
    """Errors in %, of the inclination in degrees; nan where the run became unstable."""
    candidate, dx, shear_number = item
    row = {"candidate": candidate.name, "G": shear_number, "dx_um": round(dx, 4)}
    for name, value in exact(shear_number).items():
        if results is None:
            row[f"error_{name}"] = math.nan
        elif name == "inclination_deg":
            row[f"error_{name}"] = round(mean_of(results, QUANTITIES[name]) - value, 3)
        else:
            row[f"error_{name}"] = round(100.0 * (mean_of(results, QUANTITIES[name]) / value - 1.0), 3)
    return row


def orders(rows):
    """Per candidate: errors from coarse to fine, and the order in h between 0.5 and 0.25 um."""
    for candidate in CANDIDATES:
        mine = [row for row in rows if row["candidate"] == candidate.name and row["G"] == SHEAR_NUMBER]
        at = {row["dx_um"]: row for row in mine}
        order = {name: math.log2(abs(at[0.5][f"error_{name}"] / at[0.25][f"error_{name}"])) for name in ("D", "strain", "kT")}
        yield candidate, mine, order


def cost(sweep, candidate):
    """us of the processor a step at h = 0.25 um: the difference of two short runs, the lesser of two tries."""
    name, keys, case = describe((candidate, 0.25, SHEAR_NUMBER))
    dt = 3.12e-3  # ms: S = 176
    seconds = {steps: min(sweep.processor_seconds(f"cost-{name}-{steps}", {
        **keys, "time.end": f"{steps * dt:.6g} ms", "time.average_from": "0 ms", "output.series": "1 ms", "output.frames": "10 ms"}, case)
        for _ in range(2)) for steps in (200, 1200)}
    return 1e6 * (seconds[1200] - seconds[200]) / 1000


def table(rows, costs):
    head = ("candidate", "ε at " + ", ".join(f"{dx:.3g}" for dx in (*SPACINGS, 0.2)) + " µm", "order", "D", "order",
            "kT at 0.25", "order", "angle at 0.25", "µs a step at 0.25")
    lines = [head, ("---",) * len(head)]
    for candidate, mine, order in orders(rows):
        at = {row["dx_um"]: row for row in mine}
        fine = at[0.25]
        errors = {name: ", ".join(f"{row[f'error_{name}']:+.2f}" for row in mine) + " %" for name in ("strain", "D")}
        lines.append((candidate.name, errors["strain"], f"{order['strain']:.1f}", errors["D"], f"{order['D']:.1f}", f"{fine['error_kT']:+.2f} %",
                      f"{order['kT']:.1f}", f"{fine['error_inclination_deg']:+.2f}°", f"{costs[candidate]:.0f}"))
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def style(k, candidate):
    """Colour and shape for the viscosity, filled and solid with the correction; other kernels in black."""
    if k >= 10:
        return f"with linespoints linetype 7 dashtype {k - 6} pointtype {k - 9}"
    filled = 1 if candidate.corrected else 0
    return f"with linespoints linetype {1 + k % 5} dashtype {2 - filled} pointtype {4 + 2 * (k % 5) + filled}"


def figure(sweep, rows):
    curves = [Curve(candidate.name, style(k, candidate),
                    [[row["dx_um"] for row in mine], [abs(row["error_strain"]) for row in mine]])
              for k, (candidate, mine, _) in enumerate(orders(rows))]
    curves.append(Curve("second order", "with lines linetype 7 dashtype 3", [[0.2, 0.5], [1.0, 6.25]]))
    sweep.draw("interface", 'set logscale xy\nset xrange [0.19:0.53]\nset xtics (0.2, 0.25, 0.333, 0.5)\n'
               'set xlabel "site spacing [µm]"\nset ylabel "|error of strain| [%]"\nset key outside right', curves, (820, 420))


if __name__ == "__main__":
    sweep = Sweep(__file__, __doc__)
    plan = [(candidate, dx, SHEAR_NUMBER) for dx in SPACINGS for candidate in CANDIDATES]
    plan += [(candidate, 0.2, SHEAR_NUMBER) for candidate in FINEST]
    plan += [(candidate, dx, shear_number) for shear_number in (0.05, 0.5) for dx in SPACINGS[:2] for candidate in FINEST]
    rows = sweep.tabulate(plan, describe, measure)
    costs = {candidate: cost(sweep, candidate) for candidate in CANDIDATES}
    (sweep.here / "table.md").write_text(table(rows, costs))
    figure(sweep, rows)
