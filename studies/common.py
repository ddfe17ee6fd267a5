"""What the studies share: finished runs with their averages, scatter over seeds, claims with verdicts, figures."""
from __future__ import annotations

import csv
import dataclasses
import functools
import json
import pathlib
import subprocess
import sys

import numpy as np

SOURCE = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(SOURCE / "python"))
from tanktread import Results  # noqa: E402

from runs import Plan, Run  # noqa: E402

REFERENCE = SOURCE / "tests/reference"


# --- numbers

@dataclasses.dataclass(frozen=True)
class Value:
    """Mean over seeds and its scatter."""
    mean: float
    sd: float
    count: int

    def text(self, digits: int = 3, factor: float = 1.0) -> str:
        mean = f"{self.mean * factor:.{digits}f}"
        return mean if self.count < 2 else f"{mean} ± {self.sd * factor:.{digits}f}"


def over_seeds(values) -> Value:
    """Mean and sample standard deviation over the seeds' own means."""
    values = np.asarray(list(values), dtype=float)
    return Value(values.mean(), values.std(ddof=1) if len(values) > 1 else 0.0, len(values))


def permutation_p(a, b, trials: int = 20000) -> float:
    """Chance that means as far apart as those of a and b come about by dealing their members at random."""
    a, b = np.asarray(a), np.asarray(b)
    pool, seen = np.concatenate([a, b]), abs(a.mean() - b.mean())
    deals = np.random.default_rng(2014).permuted(np.tile(pool, (trials, 1)), axis=1)
    sums = deals[:, :len(a)].sum(axis=1)
    apart = np.abs(sums / len(a) - (pool.sum() - sums) / len(b))
    return (1 + np.count_nonzero(apart >= seen - 1e-15)) / (1 + trials)


def p_text(p: float) -> str:
    return "P < 0.001" if p < 0.001 else f"P = {p:.2g}"


def r_squared(y, predicted) -> float:
    """1 - residual / variance; negative where the prediction is worse than the mean."""
    y, predicted = np.asarray(y), np.asarray(predicted)
    return 1.0 - np.sum((y - predicted) ** 2) / np.sum((y - y.mean()) ** 2)


def fit_saturation(x, y) -> tuple[float, float, float]:
    """Least squares A, b of y = A (1 - e^(-b x)), and R². A is linear; b is searched on a logarithmic grid, refined."""
    x, y = np.asarray(x), np.asarray(y)

    def amplitude(b):
        shape = -np.expm1(-b * x)
        return shape @ y / (shape @ shape)

    def misfit(b):
        return np.sum((y + amplitude(b) * np.expm1(-b * x)) ** 2)

    low, high = 1e-4 / x.max(), 50.0 / x.min()
    for _ in range(6):
        grid = np.geomspace(low, high, 200)
        best = int(np.argmin([misfit(b) for b in grid]))
        low, high = grid[max(best - 1, 0)], grid[min(best + 1, len(grid) - 1)]
    b = grid[best]
    return amplitude(b), b, r_squared(y, -amplitude(b) * np.expm1(-b * x))


def read_reference(name: str) -> list[dict[str, str]]:
    """Rows of a table of tests/reference."""
    lines = (REFERENCE / name).read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def paper_number(quantity: str, case: str, rate: int) -> tuple[float, float | None]:
    """A number of the paper's text and its standard deviation, if it gives one."""
    for row in read_reference("paper.csv"):
        if (row["quantity"], row["case"], row["pseudo_shear_rate_per_s"]) == (quantity, case, str(rate)):
            return float(row["value"]), float(row["sd"]) if row["sd"] else None
    raise KeyError((quantity, case, rate))


# --- runs that were made

class Measured:
    """A run that is done or has failed. Averages are over its window; of a failed run, the later half of what there is."""

    def __init__(self, run: Run, directory: pathlib.Path):
        self.run = run
        self.results = Results(directory)
        self.failed = status_of(directory) == "failed"
        self.end = float(self.series_table["time"][-1])
        start = dict(run.keys).get("time.average_from")
        self.window = 0.5 * self.end if start is None or self.failed else float(start.split()[0]) * 1e-3

    @functools.cached_property
    def series_table(self):
        return self.results.series

    @functools.cached_property
    def cells_table(self):
        return self.results.cells

    def series(self, name: str, whole: bool = False) -> np.ndarray:
        """A column of series.csv in the window, or over the whole run."""
        time = self.series_table["time"]
        return self.series_table[name][time >= (0.0 if whole else self.window * (1 - 1e-9))]

    def cells(self, name: str, whole: bool = False) -> np.ndarray:
        """A column of cells.csv as (times, cells)."""
        table = self.cells_table
        keep = table["time"] >= (0.0 if whole else self.window * (1 - 1e-9))
        return table[name][keep].reshape(-1, int(table["cell"].max()) + 1)

    def chosen(self, name: str) -> str:
        """What the program took for a quantity that the case leaves to it, in physical units: from the end of resolved.toml."""
        for line in (self.results.directory / "resolved.toml").read_text().splitlines():
            words = line.split("  ")
            if words[0] == f"# {name}":
                return next(word.strip() for word in words[1:] if word)
        raise KeyError(name)

    def mean(self, name: str) -> float:
        return float(np.nanmean(self.series(name)))

    def mean_of_cells(self, name: str) -> float:
        return float(np.nanmean(self.cells(name)))


def sharpest_bend(outline: np.ndarray) -> float:
    """Largest turning angle per length along an outline, times the radius of the circle of its area; 1 on a circle."""
    edge = np.roll(outline, -1, axis=0) - outline
    before = np.roll(edge, 1, axis=0)
    turn = np.arctan2(before[:, 0] * edge[:, 1] - before[:, 1] * edge[:, 0], np.sum(before * edge, axis=1))
    x, y = (outline - outline.mean(axis=0)).T
    area = 0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
    length = np.linalg.norm(edge, axis=1)
    return float(np.max(np.abs(turn) / (0.5 * (length + np.roll(length, 1)))) * np.sqrt(area / np.pi))


@dataclasses.dataclass(frozen=True)
class Health:
    """What tells a folded or an overlapping cell, over a whole run."""
    failed: bool
    stretch_min: float  # of any segment
    bend_max: float  # sharpest bend of any outline in the frames
    overlaps: float  # most nodes inside another cell at one time
    gap_min: float  # smallest gap between cells [m]
    area_error: float


@functools.cache
def health(run: Measured) -> Health:
    bends = [sharpest_bend(frame.outline(cell)) for frame in run.results.frames() for cell in range(frame.cell_count)]
    return Health(run.failed, run.cells("stretch_min", whole=True).min(), max(bends),
                  *(reduce(run.series(name, whole=True)) for name, reduce in
                    [("overlaps", np.max), ("smallest_gap", np.nanmin), ("area_error_max", np.max)]))


def failures(runs: list[Measured]) -> str:
    """How many runs failed, and when."""
    at = [run.end for run in runs if run.failed]
    return f"{len(at)} of {len(runs)} failed" + (f" at {over_seeds(at).text(2, 1e3)} ms" if at else "")


STRESSES = {"traction": "outside traction", "principal": "principal stress at the membrane's site"}


def by_wall_distance(run: Measured, stress: str) -> list[tuple[float, float, float]]:
    """(r_min [m], G*, ε): means over the looks at cells whose smallest distance to a wall is in the same 0.5 µm.

    Bins with fewer than 1 % of the looks are left out.
    """
    distance, star, strain = (run.cells(name).ravel() for name in ("wall_distance", f"shear_number_star_{stress}", "strain"))
    bins = np.floor(distance / 0.5e-6)
    chosen = [bins == k for k in np.unique(bins)]
    return [(distance[at].mean(), np.nanmean(star[at]), strain[at].mean())
            for at in chosen if np.isfinite(star[at]).sum() > 0.01 * len(bins)]


def status_of(directory: pathlib.Path) -> str:
    """done, failed, stopped, running as status.json has it; empty without one."""
    path = directory / "status.json"
    return json.loads(path.read_text())["status"] if path.exists() else ""


# --- claims and figures

@dataclasses.dataclass(frozen=True)
class Claim:
    claim: str
    paper: str
    ours: str
    reproduced: bool | None  # None: nothing to hold against the paper, only measured
    why: str

    @property
    def verdict(self) -> str:
        return {True: "reproduced", False: "not reproduced", None: "measured only"}[self.reproduced]


@dataclasses.dataclass(frozen=True)
class Curve:
    title: str  # in the key; empty: none
    style: str  # "with lines linetype 1"
    columns: list  # of equal length


def draw(out: pathlib.Path, name: str, commands: str, curves: list[Curve], size=(480, 330)) -> None:
    """Writes NAME.dat (a block a curve) and NAME.gp into `out`, and draws NAME.svg there with gnuplot."""
    out.mkdir(parents=True, exist_ok=True)
    style = SOURCE / "src/report/assets/style.gp"
    (out / "style.gp").write_text(style.read_text())
    blocks, plots = [], []
    for curve in curves:
        rows = [row for row in zip(*curve.columns)]
        lines = ["" if np.isnan(row).all() else " ".join(f"{value:.6g}" for value in row) for row in rows]
        title = curve.title.replace("'", "''")
        plots.append(f"'{name}.dat' index {len(blocks)} {curve.style} " + (f"title '{title}'" if title else "notitle"))
        blocks.append(f"# {curve.title or 'untitled'}\n" + "\n".join(lines) + "\n")
    (out / f"{name}.dat").write_text("\n\n".join(blocks))
    script = (f'load "style.gp"\nset terminal svg size {size[0]},{size[1]} dynamic background "white" '
              f'font "DejaVu Sans,Verdana,sans-serif,11"\nset output "{name}.svg"\n{commands}\n'
              + ("" if not plots else "plot " + ", \\\n     ".join(plots) + "\n"))
    (out / f"{name}.gp").write_text(script)
    subprocess.run(["gnuplot", f"{name}.gp"], cwd=out, check=True)


class Study:
    """One folder of studies/ at work: its plan, the runs already made, and where its figures go."""

    def __init__(self, plan: Plan, runs: pathlib.Path, out: pathlib.Path, loaded: dict[str, Measured]):
        self.plan = plan
        self._runs = runs
        self.out = out
        self._loaded = loaded  # shared by all studies
        self.figures: dict[str, str] = {}  # name: caption

    def load(self, run: Run) -> Measured:
        if run.name not in self._loaded:
            self._loaded[run.name] = Measured(run, self._runs / run.name)
        return self._loaded[run.name]

    def load_all(self, runs: list[Run]) -> list[Measured]:
        return [self.load(run) for run in runs]

    def draw(self, name: str, caption: str, commands: str, curves: list[Curve], size=(480, 330)) -> None:
        draw(self.out, name, commands, curves, size)
        self.figures[name] = caption


def wrapped_outline(outline: np.ndarray, length: float) -> list[np.ndarray]:
    """A closed outline [um] wherever it shows in the box: twice if it lies across an end. Rows of NaN end each."""
    closed = np.vstack([outline, outline[:1]]) * 1e6
    copies = [closed + [shift, 0.0] for shift in (-length * 1e6, 0.0, length * 1e6)]
    shown = [c for c in copies if c[:, 0].max() >= 0.0 and c[:, 0].min() <= length * 1e6]
    return [np.vstack([c, [[np.nan, np.nan]]]) for c in shown]


def outlines(frame, length: float) -> list[np.ndarray]:
    """x and y [um] of all cells of a frame, to draw with lines."""
    pieces = [p for cell in range(frame.cell_count) for p in wrapped_outline(frame.outline(cell), length)]
    return list(np.vstack(pieces).T)
