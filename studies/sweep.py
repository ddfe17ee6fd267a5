"""What the studies with runs of their own share: their command line, how runs are made, and the table beside the script."""
from __future__ import annotations

import argparse
import concurrent.futures
import csv
import pathlib
import resource
import shutil
import subprocess

from common import SOURCE, Curve, Results, draw


class Sweep:
    """One study at work. `script` and `doc` are its __file__ and __doc__.

    `quick`: keys that make each run tiny, for --quick, which then leaves tables and figures beside the runs.
    """

    def __init__(self, script: str, doc: str, quick: dict | None = None):
        self.here = pathlib.Path(script).resolve().parent
        options = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
        options.add_argument("--program", type=pathlib.Path, default=SOURCE / "build/release/tanktread")
        options.add_argument("--out", type=pathlib.Path, help=f"results/{self.here.name}, or results/{self.here.name}-quick")
        options.add_argument("-j", "--threads", type=int, default=1, help="of a run")
        options.add_argument("--jobs", type=int, default=1, help="runs at a time")
        if quick is not None:
            options.add_argument("--quick", action="store_true", help="tiny runs: a test of the script, not of physics")
        self.given = options.parse_args()
        self.is_quick = quick is not None and self.given.quick
        self.quick = quick if self.is_quick else {}
        self.given.out = self.given.out or pathlib.Path("results") / (self.here.name + "-quick" * self.is_quick)
        self.tables = self.given.out if self.is_quick else self.here

    def run(self, name: str, keys: dict, case: str | None = None, *options: str) -> Results | None:
        """A run of `case` (of cases/; else case.toml beside the script) with `keys`, made unless it is there.

        None if it became unstable. `options` of the program's verb run.
        """
        path = SOURCE / "cases" / case if case else self.here
        line = [self.given.program, "run", path / "case.toml", "-o", self.given.out / name, "-j", self.given.threads,
                "--progress", "none", *options]
        line += [word for key, value in {**keys, **self.quick}.items() for word in ("--set", f"{key}={value}")]
        made = subprocess.run([str(word) for word in line], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if made.returncode not in (0, 3):  # 3: unstable, which is a result
            raise RuntimeError(f"{name}: {made.stderr}")
        return Results(self.given.out / name) if made.returncode == 0 else None

    def processor_seconds(self, name: str, keys: dict, case: str | None = None) -> float:
        """Time of the processor, not of the clock, that a run takes. Made anew, and nothing else may run meanwhile."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.run(name, keys, case, "--fresh")
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    def tabulate(self, plan: list, describe, measure, table: str = "measured.csv") -> list[dict]:
        """The rows `measure(item, results)` of each item of `plan`, whose run is `run(*describe(item))`.

        Writes them as they come, beside the script. `results` is None of a run that became unstable.
        """
        rows: list[dict] = []
        with concurrent.futures.ThreadPoolExecutor(self.given.jobs) as pool:
            for item, results in zip(plan, pool.map(lambda item: self.run(*describe(item)), plan)):
                rows.append(measure(item, results))
                print(*rows[-1].values(), flush=True)
                self.write(table, rows)
        return rows

    def write(self, table: str, rows: list[dict]) -> None:
        """A table beside the script; all rows have the keys of the first."""
        with open(self.tables / table, "w", newline="") as file:
            writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)

    def draw(self, name: str, commands: str, curves: list[Curve], size=(480, 330)) -> None:
        """NAME.svg beside the script; its data and gnuplot script beside the runs."""
        draw(self.given.out, name, commands, curves, size)
        if not self.is_quick:
            shutil.copy(self.given.out / f"{name}.svg", self.here)


def mean_of(results: Results, name: str) -> float:
    """A mean of summary.json; nan where it has none."""
    value = results.summary[name]["mean"]
    return float("nan") if value is None else value
