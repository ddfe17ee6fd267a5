"""Fig. 10 and Eq. 24: strain against G*, by each definition of the stress."""
import numpy as np

from common import STRESSES, Claim, Curve, by_wall_distance, fit_saturation, over_seeds, paper_number, r_squared
from runs import RATES

TITLE = "Fig. 10: strain against G*, in shear and in the channel"
ORDER = 10
PAPER = (0.1771, 0.0611)  # ε = A (1 − e^(−b G*))


def runs(plan):
    shear = [run for width in (20.0, 40.0) for run in plan.shears("III", 5, width)]
    return shear + [run for rate in RATES for run in plan.channels("III", rate)]


def curve(pair, star):
    return -pair[0] * np.expm1(-pair[1] * star)


def analyse(study):
    claims = []
    for k, (stress, words) in enumerate(STRESSES.items()):
        key = f"shear_number_star_{stress}"
        shear = {width: np.array([(run.mean_of_cells(key), run.mean("strain")) for run in study.load_all(study.plan.shears("III", 5, width))]).T
                 for width in (20.0, 40.0)}
        seeds = [np.array([point for rate in RATES for point in by_wall_distance(study.load(study.plan.channel("III", rate, seed)), stress)]).T
                 for seed in study.plan.seeds]
        channel = np.hstack(seeds)[1:]
        in_shear, pooled = shear[20.0], np.hstack([shear[20.0], channel])
        common_fit = fit_saturation(*pooled)
        of_seeds = [fit_saturation(*points[1:]) for points in seeds]
        single = fit_saturation(*in_shear)
        r2 = {name: r_squared(points[1], curve(common_fit, points[0])) for name, points in [("shear", in_shear), ("channel", channel)]}
        of_paper = {name: r_squared(points[1], curve(PAPER, points[0])) for name, points in [("shear", in_shear), ("channel", channel)]}
        star = np.linspace(0, 1.05 * pooled[0].max(), 200)
        study.draw(f"strain-{stress}", f"Strain against G* by {words}, Case III, viscosity ratio 5. Channel: bins of 0.5 µm of the distance to the wall, every seed.",
                   'set xlabel "{/:Italic G}*"\nset ylabel "ε"\nset key right bottom\nset yrange [0:*]',
                   [Curve("channel", "with points linetype 6 pointtype 7 pointsize 0.35", list(channel)),
                    Curve("simple shear, walls 20 µm apart", "with points linetype 2 pointtype 7 pointsize 0.7", list(shear[20.0])),
                    Curve("simple shear, walls 40 µm apart", "with points linetype 2 pointtype 6 pointsize 0.7", list(shear[40.0])),
                    Curve("our fit to both", "with lines linetype 7", [star, curve(common_fit, star)]),
                    Curve("the paper's fit", "with lines linetype 7 dashtype 2", [star, curve(PAPER, star)])])
        a, b = (over_seeds(fit[i] for fit in of_seeds) for i in (0, 1))
        claims.append(Claim(f"one curve ε(G*) for shear and channel; G* by {words}", "R² 0.996 in shear, 0.939 in the channel",
                            f"R² of the common fit {r2['shear']:.3f} in shear, {r2['channel']:.3f} in the channel; of fits of their own "
                            f"{single[2]:.3f}, {over_seeds(fit[2] for fit in of_seeds).text()}",
                            min(r2.values()) >= 0.9, "asked: the common fit reaches R² 0.9 on both"))
        claims.append(Claim(f"the fit's numbers; G* by {words}", "A = 0.1771, b = 0.0611",
                            f"common A = {common_fit[0]:.4f}, b = {common_fit[1]:.4f}; channel alone A = {a.text(4)}, b = {b.text(4)}; "
                            f"R² of the paper's curve {of_paper['shear']:.2f} in shear, {of_paper['channel']:.2f} in the channel",
                            bool(abs(common_fit[0] / PAPER[0] - 1) < 0.2 and abs(common_fit[1] / PAPER[1] - 1) < 0.2), "asked: both within 20 %"))
        fast = study.load_all(study.plan.channels("III", 500))
        mean = over_seeds(run.mean_of_cells(key) for run in fast)
        stress_mean = over_seeds(run.mean_of_cells(f"stress_{stress}") for run in fast)
        largest = over_seeds(max(row[1] for row in by_wall_distance(run, stress)) for run in fast)
        target = paper_number("G_star_max", "III", 500)[0]
        claims.append(Claim(f"G* at 500 /s; by {words}", f"{target:g} (τ_max about 10 Pa)",
                            f"mean of all cells {mean.text(1)} ({stress_mean.text(1)} Pa), nearest the wall {largest.text(1)}",
                            min(abs(mean.mean / target - 1), abs(largest.mean / target - 1)) < 0.15, "asked: one of the two within 15 %"))
    return claims
