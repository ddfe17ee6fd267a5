"""The runs that the studies share, as data: a case file of `cases/`, the keys that differ from it, and a name.

A study asks a `Plan` for the runs it needs; runs of the same name are made once. The plan holds what is a matter of
patience, not of physics: grid, length of a run, seeds.
"""
from __future__ import annotations

import dataclasses

RATES = (50, 150, 500)  # pseudo-shear rates [/s]
CASES = {"I": "[]", "II": "shear", "III": "shear,bending,area,contact"}  # Table 1: what the hardening scales
SHEAR_NUMBERS = (0.0125, 0.025, 0.05, 0.1, 0.2, 0.5, 1.0)  # G of the sweeps in simple shear

CHANNEL_LENGTH, CHANNEL_WIDTH = 80.0, 20.0  # um
SHEAR_RATE_OF_G = 1250.0  # k = G E_s / (mu a) [/s], Eq. 19 with E_s = 6 uN/m, mu = 1.2 mPa s, a = 4 um


@dataclasses.dataclass(frozen=True)
class Run:
    name: str  # of its directory
    case: str  # folder of cases/
    keys: tuple[tuple[str, str], ...]  # what differs from the case file
    weight: float  # steps x sites, up to a common factor: for the time left

    def arguments(self) -> list[str]:
        return [word for key, value in self.keys for word in ("--set", f"{key}={value}")]


@dataclasses.dataclass(frozen=True)
class Plan:
    seeds: tuple[int, ...] = (1, 2, 3)
    channel_dx: float = 0.25  # um, for the paper's nine cases
    coarse_dx: float = 0.4  # um, for what is compared among our own runs only
    transits: float = 10.0  # of a channel run; the second half is averaged
    shear_dx: float = 0.4  # um, in the wide box
    shear_share: float = 1.0  # of the time after which a cell in shear is steady

    def channel(self, case: str, rate: int, seed: int, variant: str = "", share: float = 1.0, dx: float | None = None,
                **keys: str) -> Run:
        """Twelve cells at a nominal rate [/s], for a share of the plan's transits.

        `case`: I, II or III; `variant` names what else the keys change; `dx` [um] if not that of the plan.
        """
        variant, dx = (variant, self.channel_dx) if dx is None else (f"{variant}{'-' * bool(variant)}h{dx}", dx)
        transit = CHANNEL_LENGTH / (CHANNEL_WIDTH * rate)  # s
        time = share * self.transits * transit
        keys = {"cells.seed": str(seed), "membrane.hardening.apply_to": CASES[case],
                "flow.pseudo_shear_rate": f"{rate} /s", "numerics.dx": f"{dx} um", "time.end": f"{time * 1e3:g} ms",
                "output.series": f"{time / 500 * 1e3:g} ms", "output.frames": f"{time / 10 * 1e3:g} ms", **keys}
        return _run(f"channel-{case}-{rate}{'-' * bool(variant)}{variant}-seed{seed}", "05-channel", keys,
                    rate * time * CHANNEL_LENGTH * CHANNEL_WIDTH / dx**4)

    def channels(self, case: str, rate: int, variant: str = "", **options) -> list[Run]:
        """The same with each seed."""
        return [self.channel(case, rate, seed, variant, **options) for seed in self.seeds]

    def coarse(self, case: str, rate: int, variant: str = "", **options) -> list[Run]:
        """`channels` on the coarse grid, for questions among our own runs.

        At 500 /s the stiffness k_p that `auto` takes there, times α(λ_C), becomes unstable (studies/resolution); hence a lower one.
        """
        if rate == 500:
            options = {"membrane.area_stiffness": "1.5 kPa", **options}
        return self.channels(case, rate, variant, dx=self.coarse_dx, **options)

    def held(self, rate: int, case: str = "III") -> list[Run]:
        """`channels` with the mean velocity held instead of the pressure drop."""
        return self.channels(case, rate, "held", **{"flow.hold": "mean-velocity"})

    def shear(self, case: str, ratio: float, shear_number: float, width: float = 40.0) -> Run:
        """One cell at G between walls `width` um apart, in a box four times as long; `ratio` of the viscosities.

        A cell without hardening is steady to 1 % at k t = 8 at ratio 1, and at k t = 16, 27, 47 at ratio 5 and
        G = 0.2, 0.5, 1; the run is a quarter longer, and that quarter is averaged.
        """
        rate = SHEAR_RATE_OF_G * shear_number
        steady = self.shear_share * (8.0 if ratio < 2 else 12.0 + 36.0 * shear_number) / rate  # s
        dx = self.shear_dx if width > 30 else self.channel_dx  # narrow: as the channel it is compared with
        keys = {"domain.length": f"{4 * width:g} um", "domain.width": f"{width:g} um",
                "flow.shear_number": f"{shear_number:g}", "cells.cytoplasm_viscosity": f"{1.2 * ratio:g} cP",
                "membrane.hardening.apply_to": CASES[case], "membrane.hardening.D": "0.55",
                "membrane.hardening.beta": "16", "numerics.dx": f"{dx} um", "time.end": f"{1250 * steady:g} ms",
                "time.average_from": f"{1000 * steady:g} ms", "output.frames": f"{312.5 * steady:g} ms"}
        return _run(f"shear-{case}-ratio{ratio:g}-G{shear_number:g}-width{width:g}", "03-cell-in-shear", keys,
                    1.25 * steady * rate * 4 * width**2 / dx**4)

    def shears(self, case: str, ratio: float, width: float = 40.0) -> list[Run]:
        """The same over G."""
        return [self.shear(case, ratio, shear_number, width) for shear_number in SHEAR_NUMBERS]

    def table_1(self) -> list[Run]:
        """The paper's nine channel runs, each with every seed."""
        return [run for rate in RATES for case in CASES for run in self.channels(case, rate)]


QUICK = Plan(seeds=(1, 2), channel_dx=1.0, coarse_dx=1.0, transits=0.05, shear_dx=1.0, shear_share=0.01)  # does everything, shows nothing


def _run(name: str, case: str, keys: dict[str, str], weight: float) -> Run:
    keys = {"membrane.hold_area": "false", **keys}  # the paper keeps the area by pressure alone, and claims its hardening matters
    return Run(name, case, tuple(keys.items()), weight)
