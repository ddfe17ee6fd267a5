"""Loose pieces of outlines joined at their ends."""
from __future__ import annotations

import math

import numpy as np

from .drawing import Line, Refused, counted, place

SMALLEST = 1e-6  # [µm] shorter pieces are no pieces
FAULTS_TOLD = 10


def without_repeats(line: Line) -> Line:
    points = line.points
    keep = np.ones(len(points), bool)
    keep[1:] = np.abs(np.diff(points, axis=0)).max(axis=1, initial=0.0) > SMALLEST
    points = points[keep]
    if line.closed and len(points) > 1 and np.abs(points[0] - points[-1]).max() <= SMALLEST:
        points = points[:-1]
    return Line(points, line.closed, line.what, line.layer)


def corners(lines) -> tuple[np.ndarray, np.ndarray]:
    return np.min([line.points.min(axis=0) for line in lines], axis=0), np.max([line.points.max(axis=0) for line in lines], axis=0)


def length(line: Line) -> float:
    return float(np.hypot(*np.diff(line.points, axis=0).T).sum())


def key_of(line: Line):
    """The same for a piece and for its reverse."""
    there, back = np.round(line.points, 5).tobytes(), np.round(line.points[::-1], 5).tobytes()
    return min(there, back)


class Ends:
    """Numbers for places; those nearer than the tolerance have the same."""

    def __init__(self, tolerance: float):
        self.tolerance = tolerance
        self.cells: dict = {}
        self.at: list[np.ndarray] = []
        self.widest = 0.0

    def number(self, point: np.ndarray) -> int:
        i, j = (math.floor(c / self.tolerance) for c in point)
        nearest, least = None, self.tolerance
        for cell in ((i + a, j + b) for a in (-1, 0, 1) for b in (-1, 0, 1)):
            for k in self.cells.get(cell, ()):
                off = math.hypot(*(self.at[k] - point))
                if off <= least:
                    nearest, least = k, off
        if nearest is not None:
            self.widest = max(self.widest, least)
            return nearest
        self.at.append(point)
        self.cells.setdefault((i, j), []).append(len(self.at) - 1)
        return len(self.at) - 1


def told_open(ends: Ends, loose: list[int]) -> list[str]:
    """Each loose end with the nearest other one."""
    places = np.array([ends.at[k] for k in loose])
    told, done = [], set()
    for k, here in enumerate(places):
        if k in done:
            continue
        far = np.hypot(*(places - here).T)
        far[k] = math.inf
        other = int(far.argmin()) if len(places) > 1 else k
        done |= {k, other}
        gap = f"; the nearest other end is at {place(places[other])}, a gap of {far[other]:.4g} um" if other != k else ""
        told.append(f"an outline is open at {place(here)}{gap}; ends closer than {ends.tolerance:.3g} um are joined: "
                    "close it in the drawing program")
    more = len(told) - FAULTS_TOLD
    return told[:FAULTS_TOLD] + ([f"and {more} more open outlines"] if more > 0 else [])


def join(lines: list[Line]) -> tuple[list[Line], list[str]]:
    """Closed lines, and what was found on the way. Refuses outlines that stay open and those that branch."""
    found = []
    low, high = corners([line for line in lines if len(line.points)])
    tolerance = min(max(1e-4 * float((high - low).max()), 10 * SMALLEST), 0.2)
    given = [without_repeats(line) for line in lines]
    closed = [line for line in given if line.closed and len(line.points) > 2]
    loose = [line for line in given if not line.closed and length(line) > tolerance]
    dropped = len(given) - len(closed) - len(loose)
    if dropped:
        found.append(f"{counted(dropped, 'shape')} of no length dropped")
    once = list({key_of(line): line for line in loose}.values())
    if len(once) < len(loose):
        found.append(f"{counted(len(loose) - len(once), 'piece')} drawn twice, taken once")
    ends = Ends(tolerance)
    at_end: dict[int, list[tuple[int, bool]]] = {}
    for k, line in enumerate(once):
        for last in (False, True):
            at_end.setdefault(ends.number(line.points[-1 if last else 0]), []).append((k, last))
    branches = [node for node, there in at_end.items() if len(there) > 2]
    if branches:
        raise Refused(*[f"{len(at_end[node])} ends of lines meet at {place(ends.at[node])}; an outline goes on one way: take out "
                        "lines within the channels" for node in branches[:FAULTS_TOLD]])
    open_ends = [node for node, there in at_end.items() if len(there) == 1]
    if open_ends:
        raise Refused(*told_open(ends, open_ends))
    closed += walk(once, at_end, ends)
    if once:
        found.append(f"{counted(len(once), 'loose piece')} joined at their ends; largest gap closed {ends.widest:.2g} um, of "
                     f"{tolerance:.2g} um allowed")
    return closed, found


def walk(lines: list[Line], at_end, ends: Ends) -> list[Line]:
    """Loops of pieces; every end has two."""
    used, loops = set(), []
    nodes = {(k, last): node for node, there in at_end.items() for k, last in there}
    for first in range(len(lines)):
        if first in used:
            continue
        points, k, last = [], first, True
        while k not in used:
            used.add(k)
            piece = lines[k].points if last else lines[k].points[::-1]
            node = nodes[k, last]
            points.append(np.vstack([ends.at[nodes[k, not last]], piece[1:-1]]))
            k, last = next(((other, not at) for other, at in at_end[node] if (other, at) != (k, last)), (k, last))
        loop = np.vstack(points)
        if len(loop) > 2:
            what = lines[first].what
            loops.append(Line(loop, True, what, lines[first].layer))
    return loops
