"""Whether all four moduli have to be hardened: each left out of Case III in turn."""
import numpy as np

from common import Claim, Curve, failures, health, over_seeds

TITLE = "Are all four scalings needed?"
ORDER = 13
RATE = 500
MODULI = ("shear", "bending", "area", "contact")


def groups(plan):
    made = {"none": plan.coarse("III", RATE)}
    for left_out in MODULI:
        others = ",".join(modulus for modulus in MODULI if modulus != left_out)
        made[left_out] = plan.coarse("III", RATE, f"without-{left_out}", **{"membrane.hardening.apply_to": others})
    return made


def runs(plan):
    return [run for group in groups(plan).values() for run in group]


def analyse(study):
    made = {group: study.load_all(runs) for group, runs in groups(study.plan).items()}
    kept = {group: [health(run) for run in runs] for group, runs in made.items()}
    extension = {group: over_seeds(run.mean("lambda_C") for run in runs) for group, runs in made.items()}

    def text(group):
        rows = kept[group]
        return (f"{failures(made[group])}; λ_C {extension[group].text()}, longest cell {over_seeds(run.cells('lambda_C', whole=True).max() for run in made[group]).text(2)}; "
                f"smallest stretch {over_seeds(h.stretch_min for h in rows).text(2)}; "
                f"sharpest bend {over_seeds(h.bend_max for h in rows).text(1)}/a; smallest gap {over_seeds(h.gap_min for h in rows).text(2, 1e6)} µm; "
                f"most nodes inside another cell {max(h.overlaps for h in rows):.0f}; largest area error {over_seeds(h.area_error for h in rows).text(1, 1e3)}e-3")

    def needed(group):
        """Left out, a run fails, cells overlap or fold, or the extension leaves the band of all four by more than the scatter."""
        ill = any(h.failed or h.overlaps > 0 or h.stretch_min < 0.5 for h in kept[group])
        both = extension["none"], extension[group]
        return ill, ill or abs(both[1].mean - both[0].mean) > 2 * max(both[0].sd, both[1].sd)

    claims = [Claim("all four hardened (Case III) is stable", "stable", text("none"), not needed("none")[0], "asked: no failure, overlap or fold")]
    for group in MODULI:
        ill, moved = needed(group)
        why = "fails, folds or overlaps" if ill else "λ_C moves by more than twice the scatter" if moved else "nothing fails, folds or overlaps, and λ_C stays within twice the scatter"
        claims.append(Claim(f"hardening of {group} is needed", "needed: physical instability without" if group != "area" else "needed",
                            text(group), bool(moved), f"left out: {why}"))
    at = np.arange(len(kept))
    tics = ", ".join(f'"{"all four" if group == "none" else "no " + group}" {k}' for k, group in enumerate(kept))
    study.draw("four-scalings", "Case III at 500 /s with each scaling left out in turn: extension ratio, mean ± scatter over seeds.",
               f'set xtics ({tics})\nset xrange [-0.5:{len(kept) - 0.5}]\nset ylabel "λ_C"\nunset key',
               [Curve("", "with yerrorbars linetype 1 pointtype 7", [at, [v.mean for v in extension.values()], [v.sd for v in extension.values()]])])
    return claims
