"""Curves as chords that are off by a given length at most."""
from __future__ import annotations

import math

import numpy as np


def arc(centre, radius: float, start: float, sweep: float, off: float) -> np.ndarray:
    """Points of an arc from angle `start` over `sweep` [rad], both ends included; the middle of a chord is `off` from it."""
    ratio = min(1.0, off / radius) if radius > 0.0 else 1.0
    widest = max(2.0 * math.acos(1.0 - ratio), 1e-4)
    count = max(1, math.ceil(abs(sweep) / min(widest, math.pi / 4) - 1e-9))
    angles = start + sweep * np.arange(count + 1) / count
    return np.column_stack([centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)])


def bulged(begin, end, bulge: float, off: float) -> np.ndarray:
    """A DXF segment from `begin` to `end`, both included: an arc of angle 4 atan(bulge), to the right of the chord if positive."""
    begin, end = np.asarray(begin, float), np.asarray(end, float)
    chord = end - begin
    length = math.hypot(*chord)
    if bulge == 0.0 or length == 0.0:
        return np.array([begin, end])
    sweep = 4.0 * math.atan(bulge)
    to_centre = 0.5 * (1.0 / bulge - bulge) / 2.0  # from the middle of the chord to its left, in chords
    centre = 0.5 * (begin + end) + to_centre * np.array([-chord[1], chord[0]])
    radius = length * (1.0 + bulge * bulge) / (4.0 * abs(bulge))
    points = arc(centre, radius, math.atan2(*(begin - centre)[::-1]), sweep, off)
    points[0], points[-1] = begin, end
    return points


def bezier(control, off: float) -> np.ndarray:
    """Points of a Bézier curve of degree 2 or 3, ends included. Chords of n equal steps are off by max|P''| / (8 n²)."""
    control = np.asarray(control, float)
    degree = len(control) - 1
    second = degree * (degree - 1) * np.abs(np.diff(control, 2, axis=0)).sum(axis=1).max()
    count = max(1, math.ceil(math.sqrt(second / (8.0 * off))))
    t = (np.arange(count + 1) / count)[:, None]
    points = [control[k] for k in range(degree + 1)]
    for _ in range(degree):  # de Casteljau
        points = [(1.0 - t) * a + t * b for a, b in zip(points, points[1:])]
    return points[0]
