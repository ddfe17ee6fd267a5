"""Cells drawn with matplotlib."""
from __future__ import annotations

import numpy as np

from .frames import Frame


def draw_cells(frame: Frame, axes=None, **style):
    """Draws the outlines of a frame in µm, each wherever it shows in the box; returns the axes.

    `axes` are matplotlib's, else those in use; `style` is that of matplotlib's Polygon.
    """
    import matplotlib.pyplot
    from matplotlib.patches import Polygon

    axes = matplotlib.pyplot.gca() if axes is None else axes
    style = {"facecolor": "#d9897f", "edgecolor": "#7a1f1f", "linewidth": 0.8, **style}
    length, width = frame.box
    for cell in range(frame.cell_count):
        outline = frame.outline(cell)
        for shift in (-length, 0.0, length):
            at = outline[:, 0] + shift
            if at.max() >= 0.0 and at.min() <= length:
                axes.add_patch(Polygon(1e6 * np.column_stack([at, outline[:, 1]]), closed=True, **style))
    axes.set(xlim=(0.0, 1e6 * length), ylim=(0.0, 1e6 * width), aspect="equal", xlabel="x [µm]", ylabel="y [µm]")
    return axes
