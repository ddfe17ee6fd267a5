"""Whether G says less about strain than G* does."""
import numpy as np

from common import STRESSES, Claim, Curve, by_wall_distance, fit_saturation, over_seeds, r_squared
from runs import RATES, SHEAR_NUMBERS, SHEAR_RATE_OF_G

TITLE = "The limits of G against G*"
ORDER = 12


def runs(plan):
    shear = [run for width in (20.0, 40.0) for run in plan.shears("III", 5, width)]
    return shear + [run for rate in RATES for run in plan.channels("III", rate)]


def explained(points, rates):
    """R² of strain by G alone (the mean at each rate), and by one curve of G*, over the bins of one seed."""
    star, strain = points
    means = np.array([strain[rates == rate].mean() for rate in rates])
    a, b, by_star = fit_saturation(star, strain)
    return r_squared(strain, means), by_star


def analyse(study):
    shear = {width: np.array([run.mean("strain") for run in study.load_all(study.plan.shears("III", 5, width))]) for width in (20.0, 40.0)}
    claims = []
    for stress, words in STRESSES.items():
        shares = []
        for seed in study.plan.seeds:
            rows = [(rate, *point[1:]) for rate in RATES for point in by_wall_distance(study.load(study.plan.channel("III", rate, seed)), stress)]
            rate, *points = np.array(rows).T
            shares.append(explained(points, rate))
        by_g, by_star = (over_seeds(column) for column in zip(*shares))
        gain = over_seeds(star - g for g, star in shares)
        claims.append(Claim(f"G* says more about strain in the channel than G; G* by {words}", "ε depends on G*, not on G alone",
                            f"R² over bins of wall distance: {by_star.text(2)} by one curve of G*, {by_g.text(2)} by G alone; gain {gain.text(2)}",
                            gain.mean > gain.sd, "asked: a gain, seed by seed, beyond its scatter; by G alone means the mean strain of each rate"))
    spread = []
    for run in study.load_all(study.plan.channels("III", 150)):
        strains = [row[2] for row in by_wall_distance(run, "principal")]
        spread.append((min(strains), max(strains)))
    low, high = (over_seeds(column) for column in zip(*spread))
    claims.append(Claim("one G, many strains (150 /s, G = 0.12)", "ε 0.05 to 0.11", f"{low.text()} to {high.text()}",
                        high.mean - low.mean > 0.5 * (0.11 - 0.05), "asked: at least half of the paper's spread"))
    at = {g: {width: float(np.interp(g, SHEAR_NUMBERS, strains)) for width, strains in shear.items()} for g in (0.2, 1.0)}
    for g, paper in [(0.2, 0.05), (1.0, 0.11)]:
        claims.append(Claim(f"simple shear, 2D-LD, ε at G = {g:g}", f"{paper:.2f}", ", ".join(f"{strain:.3f} between walls {width:g} µm apart" for width, strain in at[g].items()),
                            any(abs(strain / paper - 1) <= 0.15 for strain in at[g].values()), "asked: within 15 % in one of the boxes; the paper does not give its box"))
    points = []
    for rate in RATES:
        strains = [run.mean("strain") for run in study.load_all(study.plan.channels("III", rate))]
        points.append((rate / SHEAR_RATE_OF_G, over_seeds(strains)))
    study.draw("strain-by-shear-number", "Strain against the shear number G, Case III, ratio 5. Channel: G of the nominal pseudo-shear rate; mean over cells ± scatter over seeds.",
               'set logscale x\nset xrange [0.01:1.5]\nset xlabel "{/:Italic G}"\nset ylabel "ε"\nset yrange [0:0.16]\nset key left top font ",9"',
               [Curve(f"simple shear, walls {width:g} µm apart", f"with linespoints linetype {k + 1} pointtype 7 pointsize 0.5", [SHEAR_NUMBERS, strains])
                for k, (width, strains) in enumerate(shear.items())]
               + [Curve("channel", "with yerrorbars linetype 3 pointtype 7 pointsize 0.7", [[g for g, _ in points], [v.mean for _, v in points], [v.sd for _, v in points]]),
                  Curve("the paper, simple shear", "with points linetype 7 pointtype 4 pointsize 0.8", [[0.2, 1.0], [0.05, 0.11]])])
    return claims
