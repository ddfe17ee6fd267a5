"""The cell-free layer and the relative viscosity of Case III."""
import numpy as np

from common import Claim, Curve, over_seeds, paper_number
from runs import RATES

TITLE = "Cell-free layer and relative viscosity"
ORDER = 11
HOLDS = ("pressure", "velocity")
LAYERS = {"gap": "smallest gap", "profile": "half maximum of H(y)", "core": "uniform core", "envelope": "mean envelope"}


def groups(plan):
    """(What is held, rate): runs."""
    made = {("pressure", rate): plan.channels("III", rate) for rate in RATES}
    return made | {("velocity", rate): plan.held(rate) for rate in RATES}


def runs(plan):
    return [run for group in groups(plan).values() for run in group]


def layer(run, definition):
    """As a share of the width; profile and core of the averaged H(y), as docs/theory/analysis.md advises."""
    if run.failed:
        return np.nan  # no averaged profile
    width = run.results.grid["width"]
    if definition in ("gap", "envelope"):
        return run.mean(f"cfl_{definition}") / width
    y, hematocrit = (run.results.profiles[name] for name in ("y", "hematocrit"))
    half = len(y) // 2
    y, hematocrit = y[:half], 0.5 * (hematocrit + hematocrit[::-1])[:half]
    if definition == "core":
        return (0.5 * width - hematocrit.sum() * width / (2 * half) / hematocrit.max()) / width
    k = int(np.argmax(hematocrit >= 0.5 * hematocrit.max()))
    before, y_before = (hematocrit[k - 1], y[k - 1]) if k else (0.0, 0.0)
    return (y_before + (y[k] - y_before) * (0.5 * hematocrit.max() - before) / (hematocrit[k] - before)) / width


def analyse(study):
    made = {group: study.load_all(runs) for group, runs in groups(study.plan).items()}
    claims = []
    for definition, words in LAYERS.items():
        ours = {group: over_seeds(layer(run, definition) for run in runs) for group, runs in made.items()}
        at_50 = ours["pressure", 50]
        paper = paper_number("cfl_fraction_of_width", "III", 50)[0]
        claims.append(Claim(f"CFL at 50 /s, {words}", f"about {100 * paper:.0f} % of the width",
                            f"{at_50.text(1, 100)} %; velocity held {ours['velocity', 50].text(1, 100)} %; 150 /s {ours['pressure', 150].text(1, 100)} %, "
                            f"500 /s {ours['pressure', 500].text(1, 100)} %", abs(at_50.mean - paper) <= 0.02,
                            "asked: within 2 % of the width; the paper does not give its definition"))
    viscosity = {group: over_seeds(run.mean("mu_rel") for run in runs) for group, runs in made.items()}
    reached = {group: over_seeds(run.mean("pseudo_shear_rate") for run in runs) for group, runs in made.items()}
    paper = paper_number("relative_apparent_viscosity", "III", 50)[0]
    for hold in HOLDS:
        ours = viscosity[hold, 50]
        claims.append(Claim(f"μ_rel at 50 /s, {hold} held", f"{paper:.2f}",
                            "; ".join(f"{viscosity[hold, rate].text(2)} at {rate} /s (reached {reached[hold, rate].text(0)} /s)" for rate in RATES),
                            abs(ours.mean - paper) <= max(0.05, ours.sd), "asked: within 0.05 or the scatter over seeds"))
    low, high = viscosity["velocity", 500], viscosity["velocity", 50]
    claims.append(Claim("blood thins with shear", "expected of blood", f"μ_rel {high.text(2)} at 50 /s, {low.text(2)} at 500 /s, velocity held",
                        high.mean - low.mean > high.sd + low.sd, "asked: a fall beyond the scatter over seeds"))
    study.draw("relative-viscosity", "Relative viscosity of Case III against the pseudo-shear rate that was reached; mean ± scatter over seeds.",
               'set logscale x\nset xrange [30:700]\nset yrange [1:*]\nset xlabel "pseudo-shear rate reached [s^{-1}]"\nset ylabel "μ_{rel}"\nset key right bottom',
               [Curve(f"{hold} held", f"with yerrorlines linetype {k + 1} pointtype 7 pointsize 0.6",
                      [[reached[hold, rate].mean for rate in RATES], [viscosity[hold, rate].mean for rate in RATES], [viscosity[hold, rate].sd for rate in RATES]])
                for k, hold in enumerate(HOLDS)]
               + [Curve("the paper", "with points linetype 7 pointtype 4 pointsize 0.8", [[50], [paper]])])
    return claims
