"""Fig. 9: extension ratio against lateral position."""
import numpy as np

from common import Claim, Curve, over_seeds, paper_number
from runs import RATES

TITLE = "Fig. 9: extension ratio against lateral position"
ORDER = 9
EDGES = np.linspace(0.0, 0.3, 13)  # distance of the centroid from the axis / width


def runs(plan):
    return [run for rate in RATES for run in plan.channels("III", rate)]


def profile(run):
    """Mean λ_C in bins of the centroid's distance from the axis; NaN where a cell was hardly ever (under 1 %)."""
    distance = np.abs(run.cells("y") / run.results.grid["width"] - 0.5).ravel()
    stretch = run.cells("lambda_C").ravel()
    bins = np.digitize(distance, EDGES) - 1
    return np.array([stretch[bins == k].mean() if np.count_nonzero(bins == k) > 0.01 * len(bins) else np.nan
                     for k in range(len(EDGES) - 1)])


def ends(profiles):
    """λ_C of the innermost and the outermost bin that two seeds or more have."""
    shown = [row[np.isfinite(row)] for row in profiles.T if np.isfinite(row).sum() > 1]
    return over_seeds(shown[0]), over_seeds(shown[-1])


def analyse(study):
    profiles = {rate: np.array([profile(run) for run in study.load_all(study.plan.channels("III", rate))]) for rate in RATES}
    middle = 0.5 * (EDGES[1:] + EDGES[:-1])
    curves = []
    for k, (rate, rows) in enumerate(profiles.items()):
        shown = np.isfinite(rows).sum(axis=0) > 1
        curves.append(Curve(f"{rate} /s", f"with yerrorlines linetype {k + 1} pointtype 7 pointsize 0.6",
                            [middle[shown], np.nanmean(rows[:, shown], axis=0), np.nanstd(rows[:, shown], axis=0, ddof=1)]))
    study.draw("lateral-position", "Extension ratio of Case III against the distance of a cell's centroid from the axis; mean ± scatter over the seeds that have the bin.",
               'set xlabel "distance from the axis / width"\nset ylabel "λ_C"\nset xrange [0:0.3]\nset key left top', curves)

    rises = {rate: ends(rows) for rate, rows in profiles.items()}
    inner, outer = rises[150]
    looks = [np.percentile(run.cells("strain"), (5, 95)) for run in study.load_all(study.plan.channels("III", 150))]
    few, many = (over_seeds(column) for column in zip(*looks))
    low, high = (paper_number(f"strain_range_{end}", "III", 150)[0] for end in ("low", "high"))
    return [
        Claim("λ_C grows towards the wall (150 /s)", "grows as the distance to the wall falls",
              "; ".join(f"{rate} /s: {a.text()} near the axis, {b.text()} outermost" for rate, (a, b) in rises.items()),
              outer.mean - inner.mean > outer.sd + inner.sd, "asked: a rise at 150 /s beyond the scatter over seeds"),
        Claim("range of ε at 150 /s, of bin means", f"{low:.2f} to {high:.2f}", f"{inner.mean - 1:.3f} ± {inner.sd:.3f} to {outer.mean - 1:.3f} ± {outer.sd:.3f}",
              abs(inner.mean - 1 - low) <= 0.015 and abs(outer.mean - 1 - high) <= 0.015, "asked: both ends within 0.015"),
        Claim("range of ε at 150 /s, of all cells at all times", f"{low:.2f} to {high:.2f}", f"{few.text()} to {many.text()}, 5th to 95th percentile",
              abs(few.mean - low) <= 0.015 and abs(many.mean - high) <= 0.015, "asked: the same; the paper does not say what a point of Fig. 9 is a mean of"),
    ]
