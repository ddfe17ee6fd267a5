"""What resolution and the raised Reynolds number change: no claim of the paper, but the error bar of ours."""
from common import Claim, failures, over_seeds

TITLE = "What resolution changes"
ORDER = 14
QUANTITIES = {"lambda_C": ("λ_C", 4), "mu_rel": ("μ_rel", 3), "cfl_envelope": ("CFL envelope", 2), "shear_number_star_traction": ("G* traction", 1),
              "shear_number_star_principal": ("G* principal", 1), "area_error_max": ("area error", 4)}
SCALE = "40"  # of the density, a third of what `auto` takes at 50 /s on the coarse grid


def groups(plan):
    coarse = f"h = {plan.coarse_dx} µm"
    return {f"500 /s, h = {plan.channel_dx} µm": plan.channels("III", 500),
            f"500 /s, {coarse}, k_p = 1.5 kPa": plan.coarse("III", 500),
            f"500 /s, {coarse}, k_p auto": plan.channels("III", 500, "auto-stiffness", dx=plan.coarse_dx),
            f"50 /s, h = {plan.channel_dx} µm, density scale auto": plan.channels("III", 50),
            f"50 /s, {coarse}, density scale auto": plan.coarse("III", 50),
            f"50 /s, {coarse}, density scale {SCALE}": plan.coarse("III", 50, f"scale{SCALE}", **{"numerics.density_scale": SCALE})}


def runs(plan):
    return [run for group in groups(plan).values() for run in group]


def text(made):
    def value(run, name):
        return run.mean_of_cells(name) if name.startswith("shear_number") else run.mean(name) * (1e6 if name.startswith("cfl") else 1)

    stiffness, unit = made[0].chosen("area_stiffness").split()
    chosen = f"S = {float(made[0].chosen('density_scale')):.0f}, k_p = {float(stiffness):.2g} {unit}; "
    return chosen + failures(made) + "; " + "; ".join(f"{label} {over_seeds(value(run, name) for run in made).text(digits)}{' µm' * name.startswith('cfl')}"
                     for name, (label, digits) in QUANTITIES.items())


def analyse(study):
    return [Claim(f"Case III at {name}", "", text(study.load_all(made)), None, "the same seeds") for name, made in groups(study.plan).items()]
