"""What a results directory holds."""
from __future__ import annotations

import json
import os
import pathlib
from typing import NamedTuple

import h5py

from .frames import Frame, Frames
from .sealed_file import SealedFile
from .table import Table


class Estimate(NamedTuple):
    """A mean over the averaging window. `standard_error` is None where the window does not tell it."""
    value: float
    standard_error: float | None
    unit: str  # empty for a plain number

    def __str__(self) -> str:
        error = "" if self.standard_error is None else f" ± {self.standard_error:.2g}"
        return f"{self.value:.5g}{error} {self.unit}".rstrip()


class Results:
    """A results directory. A run that is not finished has no summary and no profiles yet."""

    def __init__(self, directory: os.PathLike):
        self.directory = pathlib.Path(directory)
        if not self.directory.is_dir():
            raise FileNotFoundError(f"{self.directory}: no such results directory")

    def _table(self, name: str) -> Table:
        path = self.directory / name
        if not path.exists():
            raise FileNotFoundError(f"{path}: not written (yet)")
        return Table.read(path)

    @property
    def series(self) -> Table:
        """Measures of the whole run over time."""
        return self._table("series.csv")

    @property
    def cells(self) -> Table:
        """Measures of each cell over time: one row a cell a time."""
        return self._table("cells.csv")

    @property
    def profiles(self) -> Table:
        """Velocity and hematocrit across the channel, averaged over the window."""
        return self._table("profiles.csv")

    @property
    def ports(self) -> Table:
        """Flow rate and pressure of each port over time, and the cells that left through it."""
        return self._table("ports.csv")

    @property
    def left(self) -> Table:
        """The cells that left through ports: one row each."""
        return self._table("left.csv")

    @property
    def sections(self) -> Table:
        """Flow and cells at each section NAME over time, in columns NAME.flow_rate and so on."""
        return self._table("sections.csv")

    @property
    def section_profiles(self) -> Table:
        """Velocity and hematocrit across each section, averaged over the window; `section` is its number in `places`."""
        return self._table("section_profiles.csv")

    @property
    def places(self) -> dict:
        """Where ports and sections are [m] and how they belong together: "ports", "sections", "forks", "stretches"."""
        return self._json("places.json")

    @property
    def summary(self) -> dict:
        """What a paper would quote, {value, unit, …} by name; averages have mean, standard_error, sd_time, sd_cells, window
        and more, what is not defined a reason. Empty until the run ends."""
        return {name: entry for name, entry in self._json("summary.json").items() if name not in ("checks", "kinds")}

    @property
    def kinds(self) -> dict[str, dict]:
        """The same of the cells of each kind, by its name: what is averaged over cells. Empty where all are alike."""
        return self._json("summary.json").get("kinds", {})

    def estimate(self, name: str) -> Estimate:
        """Mean, standard error and unit of an entry of the summary. KeyError tells why one has no value."""
        entry = self.summary[name]
        if entry["value"] is None:
            raise KeyError(f"{name} has no value: {entry.get('reason', 'not measured')}")
        return Estimate(entry["value"], entry.get("standard_error"), entry["unit"])

    @property
    def checks(self) -> list[dict]:
        """What is in order and what is not, {name, verdict, value, limit, unit, sentence} each; empty until the run ends."""
        return self._json("summary.json").get("checks", [])

    @property
    def status(self) -> dict:
        """How far the run is: "status" is running, stopped, done or failed; "time" [s], "end" [s], "percent" and more."""
        return self._json("status.json")

    @property
    def provenance(self) -> dict:
        return self._json("PROVENANCE.json")

    def _json(self, name: str) -> dict:
        path = self.directory / name
        return json.loads(path.read_text()) if path.exists() else {}

    def frames(self) -> Frames:
        """All frames, as a sequence."""
        return Frames(self.directory / "frames.h5")

    def frame(self, k: int) -> Frame:
        """Frame k, from 0; -1 is the last."""
        return self.frames()[k]

    @property
    def grid(self) -> dict:
        """name, dx [m], dt [s], length [m], width [m], nx, ny of the lattice."""
        with h5py.File(SealedFile(self.directory / "frames.h5"), "r") as file:
            attributes = dict(file.attrs)
        length, width = attributes.pop("lengths")
        return {**attributes, "length": float(length), "width": float(width)}
