"""Cells drawn with matplotlib."""
from __future__ import annotations

import numpy as np

from .frames import Frame


def draw_cells(frame: Frame, axes=None, **style):
    """Draws walls and the outlines of a frame in µm, each wherever it shows in the box; returns the axes.

    `axes` are matplotlib's, else those in use; `style` is that of matplotlib's Polygon.
    """
    import matplotlib.pyplot
    from matplotlib.patches import PathPatch, Polygon
    from matplotlib.path import Path

    axes = matplotlib.pyplot.gca() if axes is None else axes
    style = {"facecolor": "#d9897f", "edgecolor": "#7a1f1f", "linewidth": 0.8, **style}
    length, width = frame.box
    if frame.walls:
        # One path of all loops, turned so that each within another goes the other way: solid by the even–odd rule.
        depth = [sum(Path(other).contains_point(loop.mean(axis=0)) for other in frame.walls if other is not loop)
                 for loop in frame.walls]
        area = [np.sum(np.roll(loop, -1, 0)[:, 1] * loop[:, 0] - np.roll(loop, -1, 0)[:, 0] * loop[:, 1])
                for loop in frame.walls]
        turned = [loop if (a > 0) == (d % 2 == 0) else loop[::-1] for loop, a, d in zip(frame.walls, area, depth)]
        closed = [Path(1e6 * np.vstack([loop, loop[:1]]), closed=True) for loop in turned]
        axes.add_patch(PathPatch(Path.make_compound_path(*closed), facecolor="#8a8a8a", edgecolor="#4a4a4a"))
    for cell in range(frame.cell_count):
        outline = frame.outline(cell)
        for along in (-length, 0.0, length):
            for up in (-width, 0.0, width):
                at = outline + (along, up)
                if np.all(at.max(axis=0) >= 0.0) and np.all(at.min(axis=0) <= (length, width)):
                    axes.add_patch(Polygon(1e6 * at, closed=True, **style))
    axes.set(xlim=(0.0, 1e6 * length), ylim=(0.0, 1e6 * width), aspect="equal", xlabel="x [µm]", ylabel="y [µm]")
    return axes
