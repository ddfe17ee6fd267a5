"""Fig. 6: shapes of the cells in the channel at 500 /s."""
import numpy as np

from common import Claim, Curve, outlines, over_seeds
from runs import CASES

TITLE = "Fig. 6: profiles in the channel at 500 /s"
ORDER = 6
RATE = 500


def runs(plan):
    return [run for case in CASES for run in plan.channels(case, RATE)]


def asymmetry(run):
    """Rms over the six pairs of |y_c + y_(c + 6) − W| / W, the rows' departure from mirror images, over time."""
    y = run.cells("y", whole=True)
    half = y.shape[1] // 2
    width = run.results.grid["width"]
    return np.sqrt(np.mean((y[:, :half] + y[:, half:] - width) ** 2, axis=1)) / width


def breaking_time(run):
    """When the rows are a tenth of the width away from mirror images, 4 times what the start may be; NaN if never."""
    late = np.flatnonzero(asymmetry(run) > 0.1)
    return run.series("time", whole=True)[late[0]] if len(late) else np.nan


def wall_share(run):
    """Mean λ_C of the looks at cells whose centroid is in the outer half of the channel, and in the inner half."""
    y, stretch = run.cells("y") / run.results.grid["width"], run.cells("lambda_C")
    outer = np.abs(y - 0.5) > 0.25
    return (np.mean(stretch[outer]) if outer.any() else np.nan), (np.mean(stretch[~outer]) if (~outer).any() else np.nan)


def analyse(study):
    made = {case: study.load_all(study.plan.channels(case, RATE)) for case in CASES}
    times = {case: np.array([breaking_time(run) for run in runs]) for case, runs in made.items()}
    walls = {case: np.array([wall_share(run) for run in runs]) for case, runs in made.items()}
    longest = {case: over_seeds(run.cells("lambda_C", whole=True).max() for run in runs) for case, runs in made.items()}
    elongation = {case: over_seeds(run.mean_of_cells("taylor_inertia") for run in runs) for case, runs in made.items()}

    for case, title in [("I", "no hardening"), ("II", "shear only"), ("III", "all four")]:
        frames = [outlines(frame, made[case][0].results.grid["length"]) for frame in made[case][0].results.frames()]
        panels = [frames[0], frames[len(frames) // 2], frames[-1]] if case == "I" else [frames[len(frames) // 2], frames[-1]]
        height = 40.0 * len(panels)
        curves = [Curve("", "with lines linetype 7 linewidth 0.7", [x, y + 25.0 * (len(panels) - 1 - k)]) for k, (x, y) in enumerate(panels)]
        study.draw(f"profiles-{case}", f"Case {case}, {title}, seed 1: " + ("at the start, " if case == "I" else "") +
                   "after five and after ten transits, from above. Axes in µm.",
                   f'unset key\nset size ratio -1\nset xrange [0:80]\nset yrange [0:{25 * len(panels) - 5}]\nset format y ""\nset ytics scale 0\n'
                   'set xlabel "{/:Italic x} [µm]"', curves, size=(480, int(75 + 3.2 * height)))

    def shown(values):
        broken = values[np.isfinite(values)]
        return f"{len(broken)} of {len(values)} seeds" + (f", at {over_seeds(broken).text(0, 1e3)} ms" if len(broken) else "")

    outer, inner = (over_seeds(walls["I"][:, k]) for k in (0, 1))
    unbroken = np.isnan(times["I"]).all()
    difference = abs(elongation["II"].mean - elongation["III"].mean)
    return [
        Claim("the symmetric start breaks within 0.1 s in Cases II and III", "typically within 0.1 s",
              f"II: {shown(times['II'])}; III: {shown(times['III'])}", bool(np.isfinite([*times["II"], *times["III"]]).all()),
              "broken: rows a tenth of the width away from mirror images; the start has a random shift of up to 0.5 µm, the paper's none"),
        Claim("Case I never breaks its symmetry before it fails", "symmetric until failure", shown(times["I"]),
              bool(unbroken and all(run.failed for run in made["I"])), "asked: no seed breaks it, and every run fails"),
        Claim("Case I cells become noodles", "more than twice the perimeter",
              f"longest λ_C {longest['I'].text(2)} (II {longest['II'].text(2)}, III {longest['III'].text(2)})", longest["I"].mean > 2.0,
              "asked: some cell beyond λ_C = 2"),
        Claim("the longest cells of Case I are near the walls", "predominantly there", f"λ_C {outer.text(2)} in the outer half, {inner.text(2)} in the inner half",
              None if np.isnan(outer.mean - inner.mean) else outer.mean > inner.mean + max(outer.sd, inner.sd), "asked: longer outside by more than the scatter over seeds"),
        Claim("shapes in II and III differ considerably", "considerably different",
              f"Taylor deformation {elongation['II'].text()} in II, {elongation['III'].text()} in III",
              difference > 2 * max(elongation["II"].sd, elongation["III"].sd), "asked: apart by more than twice the scatter over seeds"),
    ]
