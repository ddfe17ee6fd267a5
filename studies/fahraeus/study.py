#!/usr/bin/python3
"""Fahraeus and Fahraeus-Lindqvist: cells in channels of several widths.

    studies/fahraeus/study.py [--program build/release/tanktread] [--out results/fahraeus] [-j 1] [--jobs 1]

Runs what is not there yet, then writes measured.csv beside this file, with what Pries' formulae for
blood in glass tubes give at a diameter equal to the width.
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from sweep import Sweep  # noqa: E402

WIDTHS = (10, 12, 16, 20, 28, 40)  # um
SEEDS = (1, 2)


def pries_viscosity(diameter, discharge):
    """Relative viscosity in a glass tube, diameter in um (Pries, Neuhaus, Gaehtgens 1992)."""
    at_45 = 220.0 * np.exp(-1.3 * diameter) + 3.2 - 2.44 * np.exp(-0.06 * diameter**0.645)
    shift = 1.0 / (1.0 + 1e-11 * diameter**12)
    power = (0.8 + np.exp(-0.075 * diameter)) * (shift - 1.0) + shift
    return 1.0 + (at_45 - 1.0) * ((1.0 - discharge) ** power - 1.0) / (0.55**power - 1.0)


def pries_tube_ratio(diameter, discharge):
    """Tube over discharge hematocrit in a glass tube (Pries et al. 1990)."""
    return discharge + (1.0 - discharge) * (1.0 + 1.7 * np.exp(-0.415 * diameter) - 0.6 * np.exp(-0.011 * diameter))


def describe(item):
    width, seed = item
    return f"width{width}-seed{seed}", {"domain.width": f"{width} um", "cells.seed": seed}


def measure(item, results):
    """Means over the window; discharge hematocrit as the ratio of the mean fluxes."""
    width, seed = item
    series = results.series
    late = series["time"] >= 0.5 * series["time"][-1]
    mean = {name: float(np.mean(series[name][late])) for name in series}
    tube = mean["hematocrit_tube"]
    discharge = float(np.mean((series["hematocrit_discharge"] * series["flux"])[late]) / mean["flux"])
    earlier, later = np.array_split(series["mu_rel"][late], 2)
    return {"width_um": width, "seed": seed, "tube": round(tube, 4), "discharge": round(discharge, 4),
            "tube_over_discharge": round(tube / discharge, 4),
            "mu_rel": round(mean["mu_rel"], 4), "mu_rel_first_half": round(float(earlier.mean()), 4),
            "mu_rel_second_half": round(float(later.mean()), 4),
            "cfl_profile_um": round(1e6 * mean["cfl_profile"], 3), "cfl_envelope_um": round(1e6 * mean["cfl_envelope"], 3),
            "pseudo_shear_rate": round(mean["pseudo_shear_rate"], 1),
            "area_error": float(f"{series['area_error_max'].max():.2g}"),
            "pries_tube_over_discharge": round(float(pries_tube_ratio(width, discharge)), 4),
            "pries_mu_rel": round(float(pries_viscosity(width, discharge)), 4)}


if __name__ == "__main__":
    Sweep(__file__, __doc__).tabulate([(width, seed) for seed in SEEDS for width in WIDTHS], describe, measure)
