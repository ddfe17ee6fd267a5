"""Fig. 5: perimeter extension ratio of twelve cells, three cases at three rates."""
import numpy as np

from common import Claim, Curve, failures, over_seeds, p_text, paper_number, permutation_p
from runs import CASES, RATES

TITLE = "Fig. 5: extension ratio in the channel, three cases at three rates"
ORDER = 5
HELD = [("III", 50), ("III", 150), ("III", 500), ("I", 500)]  # asked again with the mean velocity held


def runs(plan):
    return plan.table_1() + [run for case, rate in HELD for run in plan.held(rate, case)]


def analyse(study):
    def cell_means(case, rate):
        return np.concatenate([run.cells("lambda_C").mean(axis=0) for run in study.load_all(study.plan.channels(case, rate))])

    claims, bars = [], {case: [] for case in [*CASES, "held"]}
    members = {(case, rate): cell_means(case, rate) for case in CASES for rate in RATES}
    for rate in RATES:
        for case in CASES:
            made = study.load_all(study.plan.channels(case, rate))
            ours = over_seeds(run.mean("lambda_C") for run in made)
            over_cells = np.mean([run.cells("lambda_C").mean(axis=0).std(ddof=1) for run in made])
            paper, sd = paper_number("lambda_C", case, rate)
            why = f"asked: within the paper's own scatter; off by {ours.mean - paper:+.3f}, the strain by {100 * ((ours.mean - 1) / (paper - 1) - 1):+.0f} %"
            claims.append(Claim(f"λ_C, Case {case} at {rate} /s", f"{paper:.3f} ± {sd:.3f}",
                                f"{ours.text()}; over cells ± {over_cells:.3f}; {failures(made)}",
                                abs(ours.mean - paper) <= sd, why))
            bars[case].append((ours.mean, ours.sd, over_cells, paper, sd))
    for case, rate in HELD:
        made = study.load_all(study.plan.held(rate, case))
        ours = over_seeds(run.mean("lambda_C") for run in made)
        paper, sd = paper_number("lambda_C", case, rate)
        claims.append(Claim(f"λ_C, Case {case} at {rate} /s with the mean velocity held", f"{paper:.3f} ± {sd:.3f}",
                            f"{ours.text()}; {failures(made)}", abs(ours.mean - paper) <= sd,
                            f"the paper does not say which it held; off by {ours.mean - paper:+.3f}"))
        if case == "III":
            bars["held"].append((ours.mean, ours.sd, 0.0, paper, sd))
    for rate, first, second, differ in [(50, "I", "III", False), (150, "I", "III", True), (150, "II", "III", False),
                                        (500, "I", "III", True), (500, "II", "III", False)]:
        p = permutation_p(members[first, rate], members[second, rate])
        gap = members[first, rate].mean() - members[second, rate].mean()
        claims.append(Claim(f"Cases {first} and {second} differ at {rate} /s", "P < 0.001" if differ else "no statistical difference",
                            f"{p_text(p)}, difference {gap:+.4f}", (p < 0.001) if differ else (p > 0.05),
                            "permutation of the time means of all cells of all seeds; cells of one run are not independent"))

    for held, runs in [("pressure drop", study.plan.channels("I", 500)), ("mean velocity", study.plan.held(500, "I"))]:
        made = study.load_all(runs)
        claims.append(Claim(f"Case I at 500 /s fails, {held} held", "before 0.1 s", f"{failures(made)}; ten transits are 80 ms",
                            all(run.failed for run in made), "asked: every run fails"))

    at = np.arange(len(RATES))
    curves = []
    for k, (case, rows) in enumerate(bars.items()):
        mean, sd, _, paper, paper_sd = np.array(rows).T
        place = at + 0.16 * (k - 1.5)
        label = f"Case {case}" if case in CASES else "Case III, velocity held"
        curves.append(Curve(label, f"with yerrorbars linetype {k + 1} pointtype 7 pointsize 0.7", [place, mean, sd]))
        if case in CASES:
            curves.append(Curve("" if k else "the paper (± over cells)",
                                f"with yerrorbars linetype {k + 1} linewidth 0.6 pointtype 4 pointsize 0.7", [place + 0.07, paper, paper_sd]))
    tics = ", ".join(f'"{rate}" {k}' for k, rate in enumerate(RATES))
    for name, top, side, part in [("extension-ratio", "*", "left top Left reverse", ""),
                                  ("extension-ratio-hardened", "1.3", "right top", " The same, without Case I at 500 /s.")]:
        study.draw(name, "Extension ratio λ_C, mean over twelve cells and the later five transits. Filled: ours, ± over seeds. Open: the paper, ± over cells." + part,
                   f'set xtics ({tics})\nset xrange [-0.5:2.5]\nset yrange [1:{top}]\nset xlabel "pseudo-shear rate [s^{{-1}}]"\n'
                   f'set ylabel "λ_C"\nset key {side}', curves)
    return claims
