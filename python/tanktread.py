"""Reads a results directory of tanktread. Needs h5py and numpy.

    from tanktread import Results
    run = Results("results/channel-500-LD")
    run.series["time"], run.series["lambda_C"]      # numpy arrays, SI
    run.cells.of_cell(3)["taylor_inertia"]          # one cell over time
    run.profiles["y"], run.profiles["velocity"]
    for frame in run.frames():
        frame.time, frame.outline(0), frame.velocity
"""
from __future__ import annotations

import json
import os
import pathlib
import re

import h5py
import numpy as np


class Table:
    """Columns of numbers by name, SI. `units[name]` is empty for a plain number."""

    def __init__(self, columns: dict[str, np.ndarray], units: dict[str, str]):
        self.columns = columns
        self.units = units

    @classmethod
    def read(cls, path: os.PathLike) -> "Table":
        """Reads a CSV file whose header is `name [unit],…`; a last line that is cut short is left out."""
        lines = [line for line in pathlib.Path(path).read_text().splitlines() if line.strip() and not line.startswith("#")]
        titles = [re.fullmatch(r"\s*(.*?)\s*(?:\[(.*)\])?\s*", title).groups() for title in lines[0].split(",")]
        rows = [line.split(",") for line in lines[1:]]
        if rows and len(rows[-1]) < len(titles):
            rows.pop()
        values = np.array(rows, dtype=float).reshape(len(rows), len(titles))
        return cls({name: values[:, k] for k, (name, _) in enumerate(titles)}, {name: unit or "" for name, unit in titles})

    def __getitem__(self, name: str) -> np.ndarray:
        return self.columns[name]

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __iter__(self):
        return iter(self.columns)

    def __len__(self) -> int:
        """Number of rows."""
        return len(next(iter(self.columns.values()), ()))

    def where(self, mask: np.ndarray) -> "Table":
        """The rows where `mask` is true."""
        return Table({name: values[mask] for name, values in self.columns.items()}, self.units)

    def of_cell(self, cell: int) -> "Table":
        """The rows of one cell, for tables with a column `cell`."""
        return self.where(self["cell"] == cell)


class Frame:
    """Membranes and fields at one time, SI. Arrays are read when asked for.

    nodes, node_force, node_velocity: (N, 2); velocity: (ny, nx, 2); pressure, cytoplasm: (ny, nx), row 0 at the bottom.
    Node positions are not wrapped: x counts on when a cell leaves through an end.
    """

    def __init__(self, group: h5py.Group, first: np.ndarray, length: float):
        self.time = float(group.attrs["time"])
        self.step = int(group.attrs["step"])
        self._group = group
        self._first = first
        self._length = length

    def __getattr__(self, name: str) -> np.ndarray:
        if not name.startswith("_") and name in self._group:
            return self._group[name][()]
        raise AttributeError(f"the frame has no dataset '{name}'")

    @property
    def cell_count(self) -> int:
        return len(self._first) - 1

    def outline(self, cell: int, wrapped: bool = True) -> np.ndarray:
        """Nodes of one cell, (n, 2) [m]; `wrapped` moves the cell as a whole so that its mean x lies in the box."""
        nodes = self._group["nodes"][self._first[cell]:self._first[cell + 1]]
        if wrapped:
            nodes[:, 0] -= self._length * np.floor(nodes[:, 0].mean() / self._length)
        return nodes


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
    def summary(self) -> dict:
        """What a paper would quote, {value, unit, …} by name; averages have mean, standard_error, sd_time, sd_cells, window
        and more, what is not defined a reason. Empty until the run ends."""
        return {name: entry for name, entry in self._json("summary.json").items() if name != "checks"}

    @property
    def checks(self) -> list[dict]:
        """What is in order and what is not, {name, verdict, value, limit, unit, sentence} each; empty until the run ends."""
        return self._json("summary.json").get("checks", [])

    @property
    def provenance(self) -> dict:
        return self._json("PROVENANCE.json")

    def _json(self, name: str) -> dict:
        path = self.directory / name
        return json.loads(path.read_text()) if path.exists() else {}

    def frames(self):
        """Yields each frame in order. A frame's arrays can be read until the next one is taken."""
        with h5py.File(self.directory / "frames.h5", "r") as file:
            first = file["first"][()]
            length = float(file.attrs["lengths"][0])
            for name in sorted(file["frames"]):
                yield Frame(file["frames"][name], first, length)

    @property
    def grid(self) -> dict:
        """name, dx [m], dt [s], length [m], width [m], nx, ny of the lattice."""
        with h5py.File(self.directory / "frames.h5", "r") as file:
            attributes = dict(file.attrs)
        length, width = attributes.pop("lengths")
        return {**attributes, "length": float(length), "width": float(width)}
