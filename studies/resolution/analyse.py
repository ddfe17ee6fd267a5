"""What resolution and the raised Reynolds number change: no claim of the paper, but the error bar of ours."""
import dataclasses

from common import Claim, over_seeds

TITLE = "What resolution changes"
ORDER = 14
SPACINGS = (0.4, 0.25, 0.2)  # um
QUANTITIES = {"lambda_C": ("λ_C", 4), "mu_rel": ("μ_rel", 3), "cfl_envelope": ("CFL envelope", 2), "shear_number_star_traction": ("G* traction", 1),
              "shear_number_star_principal": ("G* principal", 1)}
SLOW_SCALE = "75"  # of the density, a quarter of what `auto` takes at 50 /s


def at(plan, dx):
    """The plan at another spacing; as it is for a plan that is coarser anyway."""
    return dataclasses.replace(plan, channel_dx=max(dx, plan.channel_dx) if plan.channel_dx > 0.5 else dx)


def spaced(plan, dx):
    return at(plan, dx).channels("III", 500, "" if dx == plan.channel_dx else f"dx{dx}")


def slowed(plan):
    coarse = at(plan, SPACINGS[0])
    return coarse.channels("III", 50, "dx0.4"), coarse.channels("III", 50, f"dx0.4-scale{SLOW_SCALE}", **{"numerics.density_scale": SLOW_SCALE})


def runs(plan):
    return [run for dx in SPACINGS for run in spaced(plan, dx)] + [run for group in slowed(plan) for run in group]


def text(made):
    def value(run, name):
        return run.mean_of_cells(name) if name.startswith("shear_number") else run.mean(name) * (1e6 if name.startswith("cfl") else 1)

    return "; ".join(f"{label} {over_seeds(value(run, name) for run in made).text(digits)}{' µm' * name.startswith('cfl')}"
                     for name, (label, digits) in QUANTITIES.items())


def analyse(study):
    claims = [Claim(f"Case III at 500 /s, h = {dx} µm", "", text(study.load_all(spaced(study.plan, dx))), None, "same seeds at each spacing") for dx in SPACINGS]
    auto, slow = slowed(study.plan)
    claims += [Claim("Case III at 50 /s, h = 0.4 µm, density scale auto (293)", "", text(study.load_all(auto)), None, "Reynolds number of a cell as run 0.2"),
               Claim(f"the same, density scale {SLOW_SCALE}", "", text(study.load_all(slow)), None, "a quarter of it")]
    return claims
