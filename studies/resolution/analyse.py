"""What resolution and the raised Reynolds number change: no claim of the paper, but the error bar of ours."""
from common import Claim, over_seeds

TITLE = "What resolution changes"
ORDER = 14
QUANTITIES = {"lambda_C": ("λ_C", 4), "mu_rel": ("μ_rel", 3), "cfl_envelope": ("CFL envelope", 2), "shear_number_star_traction": ("G* traction", 1),
              "shear_number_star_principal": ("G* principal", 1)}
SCALE = "100"  # of the density, a third of what `auto` takes at 50 /s on the coarse grid


def spaced(plan):
    return {dx: plan.channels("III", 500, dx=None if dx == plan.channel_dx else dx) for dx in (plan.coarse_dx, plan.channel_dx)}


def scaled(plan):
    return plan.not_held(50), plan.channels("III", 50, f"scale{SCALE}", dx=plan.coarse_dx, **{"numerics.density_scale": SCALE})


def runs(plan):
    return [run for group in (*spaced(plan).values(), *scaled(plan)) for run in group]


def text(made):
    def value(run, name):
        return run.mean_of_cells(name) if name.startswith("shear_number") else run.mean(name) * (1e6 if name.startswith("cfl") else 1)

    return "; ".join(f"{label} {over_seeds(value(run, name) for run in made).text(digits)}{' µm' * name.startswith('cfl')}"
                     for name, (label, digits) in QUANTITIES.items())


def analyse(study):
    claims = [Claim(f"Case III at 500 /s, h = {dx} µm", "", text(study.load_all(made)), None, "same seeds at each spacing") for dx, made in spaced(study.plan).items()]
    auto, scale = scaled(study.plan)
    where = f"Case III at 50 /s, h = {study.plan.coarse_dx} µm, density scale"
    return claims + [Claim(f"{where} auto (293)", "", text(study.load_all(auto)), None, "Reynolds number of a cell as run 0.2"),
                     Claim(f"{where} {SCALE}", "", text(study.load_all(scale)), None, "a third of it")]
