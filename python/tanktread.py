"""Reads a results directory of tanktread. Needs h5py and numpy.

    from tanktread import Results
    run = Results("results/channel-500-LD")
    run.series["time"], run.series["lambda_C"]      # numpy arrays, SI
    run.cells.of_cell(3)["taylor_inertia"]          # one cell over time
    run.profiles["y"], run.profiles["velocity"]
    for frame in run.frames():                      # a sequence: len(), [k], [-1]
        frame.time, frame.outline(0), frame.velocity
    run.frame(-1).nodes                             # the last
"""
from __future__ import annotations

import collections.abc
import io
import json
import os
import pathlib
import re
import struct
import warnings
import zlib

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


class SealedFile(io.RawIOBase):
    """The content of a file that carries checksums of its blocks behind it, as tanktread writes frames.h5.

    A read of damaged bytes raises OSError. Without a seal (`sealed` false) nothing is known of the bytes.
    """
    BLOCK = 4096
    FOOTER = struct.Struct("<8sQI")  # "tt-seal1", bytes of content, CRC-32 of the table and the footer before it

    def __init__(self, path: os.PathLike):
        self.path = pathlib.Path(path)
        self._file = open(path, "rb", buffering=0)
        self._at = 0
        self.size = self._file.seek(0, os.SEEK_END)
        self.sealed = self._read_seal()

    def _read_seal(self) -> bool:
        end = self.size
        if end < self.FOOTER.size:
            return False
        footer = self._read_at(end - self.FOOTER.size, self.FOOTER.size)
        magic, content, stated = self.FOOTER.unpack(footer)
        table_size = 4 * -(-content // self.BLOCK)
        if magic != b"tt-seal1" or content + table_size + self.FOOTER.size != end:
            return False
        table = self._read_at(content, table_size)
        if zlib.crc32(footer[:-4], zlib.crc32(table)) != stated:
            return False
        self._table = np.frombuffer(table, "<u4")
        self.size = content
        return True

    def _read_at(self, offset: int, count: int) -> bytes:
        self._file.seek(offset)
        parts = []
        while count > 0:
            part = self._file.read(count)
            if not part:
                raise OSError(f"{self.path}: cut short")
            parts.append(part)
            count -= len(part)
        return b"".join(parts)

    def close(self):
        self._file.close()
        super().close()

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        self._at = offset + {os.SEEK_SET: 0, os.SEEK_CUR: self._at, os.SEEK_END: self.size}[whence]
        return self._at

    def tell(self) -> int:
        return self._at

    def readinto(self, buffer) -> int:
        wanted = memoryview(buffer).cast("B")
        end = min(self._at + len(wanted), self.size)
        if end <= self._at:
            return 0
        first = self._at // self.BLOCK
        whole = self._read_at(first * self.BLOCK, min(-(-end // self.BLOCK) * self.BLOCK, self.size) - first * self.BLOCK)
        if self.sealed:
            for k in range(0, len(whole), self.BLOCK):
                if zlib.crc32(whole[k:k + self.BLOCK]) != self._table[first + k // self.BLOCK]:
                    raise OSError(f"{self.path}: damaged")
        start = self._at - first * self.BLOCK
        count = end - self._at
        wanted[:count] = whole[start:start + count]
        self._at = end
        return count


class Frame:
    """Membranes and fields at one time, SI: arrays in memory, each its own (they outlive the file).

    nodes, node_force, node_velocity: (N, 2); velocity: (ny, nx, 2); pressure, cytoplasm: (ny, nx), row 0 at the bottom.
    Node positions are not wrapped: x counts on when a cell leaves through an end.
    """

    def __init__(self, group: h5py.Group, first: np.ndarray, length: float):
        self.number = int(group.name.rpartition("/")[2])
        self.time = float(group.attrs["time"])
        self.step = int(group.attrs["step"])
        self.__dict__.update({name: dataset[()] for name, dataset in group.items()})
        self._first = first
        self._length = length

    def __getattr__(self, name: str) -> np.ndarray:
        raise AttributeError(f"the frame has no dataset '{name}'")

    @property
    def cell_count(self) -> int:
        return len(self._first) - 1

    def outline(self, cell: int, wrapped: bool = True) -> np.ndarray:
        """Nodes of one cell, (n, 2) [m]; `wrapped` moves the cell as a whole so that its mean x lies in the box."""
        nodes = self.nodes[self._first[cell]:self._first[cell + 1]].copy()
        if wrapped:
            nodes[:, 0] -= self._length * np.floor(nodes[:, 0].mean() / self._length)
        return nodes


class Frames(collections.abc.Sequence):
    """The frames of a run in order: len(), [k], [-1], slices, iteration. One is read when it is asked for.

    Iteration leaves out a frame that is damaged, with a warning; asking for it raises OSError.
    """

    def __init__(self, path: pathlib.Path):
        self._places = []  # (file, name of the group) of each frame
        with h5py.File(SealedFile(path), "r") as file:
            for name in sorted(file["frames"]):
                link = file["frames"].get(name, getlink=True)  # to another file until the run has ended
                self._places.append((path.parent / link.filename if isinstance(link, h5py.ExternalLink) else path, name))

    def __len__(self) -> int:
        return len(self._places)

    def __getitem__(self, k):
        if isinstance(k, slice):
            return [self._read(*place) for place in self._places[k]]
        return self._read(*self._places[k])

    def __iter__(self):
        for path, name in self._places:
            try:
                frame = self._read(path, name)
            except OSError as error:
                warnings.warn(f"left out: {error}", stacklevel=2)
            else:
                yield frame

    @staticmethod
    def _read(path: pathlib.Path, name: str) -> Frame:
        try:
            with SealedFile(path) as bytes_, h5py.File(bytes_, "r") as file:
                if not bytes_.sealed:
                    warnings.warn(f"{path} has no checksums: whether its frames are sound is not known", stacklevel=3)
                return Frame(file["frames"][name], file["first"][()], float(file.attrs["lengths"][0]))
        except (OSError, KeyError, RuntimeError, ValueError) as error:
            raise OSError(f"frame {int(name)} of {path} is damaged ({error})") from None


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
