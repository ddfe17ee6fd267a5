"""Membranes and fields at one time, from frames.h5."""
from __future__ import annotations

import collections.abc
import pathlib
import warnings

import h5py
import numpy as np

from .sealed_file import SealedFile


class Frame:
    """Membranes and fields at one time, SI: arrays in memory, each its own (they outlive the file).

    nodes, node_force, node_velocity: (N, 2); velocity: (ny, nx, 2); pressure, cytoplasm: (ny, nx), row 0 at the bottom.
    `units` has their units by name; `box` is length and width [m]. A frame without fields has no velocity, pressure, cytoplasm.
    Node positions are not wrapped: x counts on when a cell leaves through an end.
    `kind` is the number of the kind of each cell, and `kinds` has their names; one without a name where all are alike.
    `walls` are loops of corners (n, 2) [m]; solid is what an odd number of them goes around, and fields are nan there.
    In a straight channel there are none.
    """

    def __init__(self, group: h5py.Group, cells: dict, box: tuple[float, float], walls: list[np.ndarray]):
        self.number = int(group.name.rpartition("/")[2])
        self.time = float(group.attrs["time"])
        self.step = int(group.attrs["step"])
        self.box = box
        self.units = {name: dataset.attrs.get("unit", "") for name, dataset in group.items()}
        self.__dict__.update({name: dataset[()] for name, dataset in group.items()})
        self.walls = walls
        first = cells["first"]
        self._first = first[first <= group["nodes"].shape[0]]  # cells that came later have no nodes here
        self.kind = cells["kind"][:len(self._first) - 1]
        self.kinds = cells["kinds"]

    def __getattr__(self, name: str) -> np.ndarray:
        raise AttributeError(f"the frame has no dataset '{name}'")

    @property
    def cell_count(self) -> int:
        return len(self._first) - 1

    def outline(self, cell: int, wrapped: bool = True) -> np.ndarray:
        """Nodes of one cell, (n, 2) [m]; `wrapped` moves the cell as a whole so that its mean lies in the box."""
        nodes = self.nodes[self._first[cell]:self._first[cell + 1]].copy()
        if wrapped:
            nodes -= self.box * np.floor(nodes.mean(axis=0) / self.box)
        return nodes


    def to_xarray(self):
        """The fields as an xarray Dataset over y and x [m], the sites' centres; velocity over `component` too."""
        import xarray

        ny, nx = self.pressure.shape
        at = {name: (name, (np.arange(count) + 0.5) * extent / count, {"units": "m"})
              for name, count, extent in (("y", ny, self.box[1]), ("x", nx, self.box[0]))}
        fields = {name: (("y", "x", "component")[:getattr(self, name).ndim], getattr(self, name), {"units": self.units[name]})
                  for name in ("velocity", "pressure", "cytoplasm")}
        return xarray.Dataset(fields, {**at, "component": ["x", "y"]}, {"time": self.time})


def _cells_of(file: h5py.File) -> dict:
    """Which nodes are whose, and the kinds of the cells; files of other writers may not tell these."""
    first = file["first"][()]
    kind = file["kind"][()] if "kind" in file else np.zeros(len(first) - 1, dtype=np.int32)
    return {"first": first, "kind": kind, "kinds": str(file.attrs.get("kinds", "")).split(",")}


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
                walls = np.split(file["walls"][()], file["wall_first"][1:-1]) if "walls" in file else []
                return Frame(file["frames"][name], _cells_of(file), tuple(map(float, file.attrs["lengths"])), walls)
        except (OSError, KeyError, RuntimeError, ValueError) as error:
            raise OSError(f"frame {int(name)} of {path} is damaged ({error})") from None
