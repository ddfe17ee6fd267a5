"""Figs. 7 and 8: whether Case II buckles, and what makes it."""
import numpy as np

from common import Claim, Curve, failures, health, over_seeds

TITLE = "Figs. 7 and 8: buckling in Case II, and its cause"
ORDER = 7
RATE = 500
PRINTED = {"membrane.hardening.compression": "as-printed"}
# The pair that the paper's two points in simple shear ask for (D_LD = 0.25, beta = 4, D = D_LD e^beta). With it k_p alpha
# would pass its limit at the stiffness that `auto` takes, hence a softer one.
SOFT = {"membrane.hardening.D": "13.65", "membrane.hardening.beta": "4", "membrane.area_stiffness": "1 kPa"}


def groups(plan):
    """(case, what is different): runs."""
    made = {}
    for case in ("II", "III"):
        made[case, "default"] = plan.channels(case, RATE)
        made[case, "printed"] = plan.coarse(case, RATE, "printed", **PRINTED)
        made[case, "soft"] = plan.coarse(case, RATE, "soft", share=0.2, **SOFT)
        made[case, "soft printed"] = plan.channels(case, RATE, "soft-printed", share=0.005, **SOFT, **PRINTED, **{
            "output.frames": "0.01 ms", "output.series": "0.002 ms"})
    return made


def runs(plan):
    return [run for group in groups(plan).values() for run in group]


def hardened_tension(stretch, d, beta):
    """T(λ) α(λ)/E_s of Eqs. 11 and 12 as printed also in compression, with α(1) = 1."""
    return (stretch**3 - 1) / stretch**1.5 * (1 + d * np.expm1(beta * (stretch - 1)))


def turning_point(d, beta):
    """The stretch below 1 at which further compression meets a falling force; NaN if there is none down to 0.5."""
    stretch = np.linspace(1.0, 0.5, 5001)
    falling = np.flatnonzero(np.diff(hardened_tension(stretch, d, beta)) > 0)
    return stretch[falling[0]] if len(falling) else np.nan


def analyse(study):
    made = {group: study.load_all(runs) for group, runs in groups(study.plan).items()}
    kept = {group: [health(run) for run in runs] for group, runs in made.items()}

    def text(group):
        rows = kept[group]
        return (f"{group[0]}: {failures(made[group])}; smallest stretch {over_seeds(h.stretch_min for h in rows).text(2)}, sharpest bend "
                f"{over_seeds(h.bend_max for h in rows).text(1)}/a, most nodes inside another cell {max(h.overlaps for h in rows):.0f}")

    def both(kind):
        return text(("II", kind)) + " | " + text(("III", kind))

    def fails(case, kind):
        return all(run.failed for run in made[case, kind])

    def none_fails(case, kind):
        return not any(run.failed for run in made[case, kind])

    pairs = {"D = 0.55, β = 16": (0.55, 16.0), "D = 13.65, β = 4": (13.65, 4.0)}
    stretch = np.linspace(0.8, 1.1, 200)
    study.draw("hardened-tension", "Tension T α in compression and extension, with Eq. 12 as printed also for λ < 1. Where it falls "
               "on the way to the left, a segment that is pressed gives way.",
               'set xlabel "stretch λ"\nset ylabel "{/:Italic T} α / {/:Italic E}_s"\nset yrange [-0.4:1]\nset key left top\n'
               'set xzeroaxis linetype 7 linewidth 0.4',
               [Curve(label, f"with lines linetype {k + 1}", [stretch, hardened_tension(stretch, *pair)]) for k, (label, pair) in enumerate(pairs.items())])
    curves = []
    for k, case in enumerate(("II", "III")):
        for run in made[case, "soft printed"]:
            curves.append(Curve(f"Case {case}" if run.run.name.endswith("seed1") else "", f"with lines linetype {k + 1} dashtype {k + 1}",
                                [run.series("time", whole=True) * 1e3, run.cells("stretch_min", whole=True).min(axis=1)]))
    study.draw("buckling", "The smallest stretch of any segment until the run fails, with D = 13.65, β = 4 and Eq. 12 as printed in compression; three seeds each.",
               'set xlabel "{/:Italic t} [ms]"\nset ylabel "smallest stretch"\nset yrange [0:1.02]\nset key left bottom', curves)

    turning = {label: turning_point(*pair) for label, pair in pairs.items()}
    return [
        Claim("Case II buckles and fails, Case III does not", "regular in II, avoided in III", both("default"),
              fails("II", "default") and none_fails("III", "default"), "default pair, α(2 − λ) in compression; asked: every run of II fails, none of III"),
        Claim("the same with Eq. 12 as printed in compression", "regular in II, avoided in III", both("printed"),
              fails("II", "printed") and none_fails("III", "printed"), "default pair, h = 0.4 µm; α < 1 for λ < 1, but the tension stays monotone"),
        Claim("the same with hardening soft at rest, as the paper's simple shear asks, as printed in compression", "regular in II, avoided in III",
              both("soft printed"), fails("II", "soft printed") and none_fails("III", "soft printed"),
              "D = 13.65, β = 4; if both fail, scaling the bending does not cure it"),
        Claim("the same pair with α(2 − λ) in compression", "", both("soft"), None, "h = 0.4 µm, two transits; a change of the branch for λ < 1 alone"),
        Claim("the cause is compressed segments (Fig. 8)", "compressive forces against the spontaneous curvature",
              "tension turns back at " + ", ".join(f"λ = {at:.3f} ({label})" if np.isfinite(at) else f"no λ ({label})" for label, at in turning.items()),
              fails("II", "soft printed") and none_fails("II", "soft") and none_fails("II", "printed"),
              "asked: Case II fails with the pair that turns back, and neither with that pair's symmetric branch nor with the pair that does not"),
        Claim("the cause is that bending is not scaled", "scaling it avoids the instability",
              f"Case III with the pair that turns back: {failures(made['III', 'soft printed'])}",
              none_fails("III", "soft printed") and fails("II", "soft printed"), "asked: Case III survives where Case II fails"),
    ]
