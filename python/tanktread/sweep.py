"""Sweeps: one case over values of its keys."""
from __future__ import annotations

import csv
import json
import os
import pathlib
import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from .program import STOPPED, UNSTABLE, call, raise_if_failed, setting_text, settings
from .results import Results
from .table import Table


class SweptRun(NamedTuple):
    """A run of a sweep."""
    name: str
    values: dict[str, str]  # of the swept keys, as they were written
    ending: str  # done, failed, stopped or waiting
    why: str  # of one that failed
    directory: pathlib.Path

    @property
    def results(self) -> Results:
        return Results(self.directory)


class Sweep:
    """The directory of a sweep. len(), [k] and a loop give its runs."""

    def __init__(self, directory: os.PathLike):
        self.directory = pathlib.Path(directory)
        path = self.directory / "sweep.json"
        if not path.exists():
            raise FileNotFoundError(f"{path}: no such sweep")
        self._record = json.loads(path.read_text())

    @property
    def runs(self) -> list[SweptRun]:
        return [SweptRun(run["name"], run["values"], run["ending"], run.get("why", ""), self.directory / run["directory"])
                for run in self._record["runs"]]

    def __len__(self) -> int:
        return len(self._record["runs"])

    def __getitem__(self, k: int) -> SweptRun:
        return self.runs[k]

    @property
    def failed(self) -> list[SweptRun]:
        return [run for run in self.runs if run.ending == "failed"]

    @property
    def table(self) -> Table:
        """table.csv: a row a run, with swept keys, means and their standard errors in SI. A run that is not done has nan."""
        with open(self.directory / "table.csv", newline="") as file:
            titles, *rows = csv.reader(file)
        columns, units = {}, {}
        for k, title in enumerate(titles):
            name, unit = re.fullmatch(r"(.*?)(?: \[(.*)\])?", title).groups()
            texts = [row[k] for row in rows]
            try:
                columns[name] = np.array([float(text) if text else np.nan for text in texts])
            except ValueError:
                columns[name] = np.array(texts, dtype=object)
            units[name] = unit or ""
        return Table(columns, units)


def sweep(case: os.PathLike, output: os.PathLike, *, over: Mapping[str | tuple[str, ...], Sequence] = {}, set: Mapping[str, object] = {},
          jobs: int | None = None, max_time: str | None = None, retry: bool = False, program: str | None = None) -> Sweep:
    """Runs a case over values of its keys, or goes on with the sweep in `output`, and returns it.

    Each entry of `over` is an axis: a key with its values, {"flow.shear_number": [0.1, 0.2]}, or keys that change together,
    {("domain.width", "domain.length"): [("20 um", "80 um"), ("40 um", "160 um")]}. Without `over`, `case` is the file of a
    sweep. `jobs` runs go side by side. Runs that blow up are in `.failed`; `retry` begins them anew. Stopped by `max_time`
    ("55m"), the sweep is returned as far as it came. Raises BadCase, InUse or ProgramError with the program's message.
    """
    words = ["sweep", os.fspath(case), "-o", os.fspath(output), "--progress", "none", *settings(set)]
    for keys, values in over.items():
        words += ["--over", _axis(keys, values)]
    for option, value in [("-j", jobs), ("--max-time", max_time)]:
        if value is not None:
            words += [option, str(value)]
    code, _, message = call(program, words + ["--retry"] * retry)
    if code not in (STOPPED, UNSTABLE):
        raise_if_failed(code, message)
    return Sweep(output)


def _axis(keys: str | tuple[str, ...], values: Sequence) -> str:
    rows = [(value,) for value in values] if isinstance(keys, str) else values
    keys = (keys,) if isinstance(keys, str) else keys
    return "; ".join(f"{key}={', '.join(_value(row[k]) for row in rows)}" for k, key in enumerate(keys))


def _value(value: object) -> str:
    return json.dumps(value) if isinstance(value, str) else setting_text(value)
