"""Tables of numbers with units: series.csv, cells.csv, profiles.csv."""
from __future__ import annotations

import os
import pathlib
import re

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

    def to_pandas(self):
        """A pandas DataFrame; its `attrs["units"]` are the units by name."""
        import pandas

        frame = pandas.DataFrame(self.columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self):
        """An xarray Dataset whose variables have the attribute `units`: over time, or y in a profile; of cells.csv over
        time and cell."""
        import xarray

        along = next(iter(self.columns))
        if "cell" not in self:
            at = {along: (along, self[along], {"units": self.units[along]})}
            shape, dimensions = (len(self),), (along,)
        else:
            cells = np.unique(self["cell"]).astype(int)
            shape, dimensions = (len(self) // len(cells), len(cells)), (along, "cell")
            at = {along: (along, self[along].reshape(shape)[:, 0], {"units": self.units[along]}), "cell": cells}
        return xarray.Dataset({name: (dimensions, values.reshape(shape), {"units": self.units[name]})
                               for name, values in self.columns.items() if name not in at}, at)

    def where(self, mask: np.ndarray) -> "Table":
        """The rows where `mask` is true."""
        return Table({name: values[mask] for name, values in self.columns.items()}, self.units)

    def of_cell(self, cell: int) -> "Table":
        """The rows of one cell, for tables with a column `cell`."""
        return self.where(self["cell"] == cell)
