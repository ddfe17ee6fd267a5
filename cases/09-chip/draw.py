#!/usr/bin/env python3
"""Draws chip.dxf, in mm, as a CAD program would save it. Needs python3-ezdxf."""
import math
import pathlib

import ezdxf

ROUND = math.tan(math.pi / 8)  # bulge of a quarter circle

doc = ezdxf.new("R2010")
doc.header["$INSUNITS"] = 4  # mm
doc.layers.add("CHANNELS", color=5)
doc.layers.add("FRAME", color=8)
doc.layers.add("LABELS", color=7)
space = doc.modelspace()


def outline(points, layer):
    space.add_lwpolyline([(x * 1e-3, y * 1e-3, bulge) for x, y, bulge in points], format="xyb", close=True, dxfattribs={"layer": layer})


# From the inlet on the left along the lower wall, and back along the upper one [um]; the third number bends the way to the next point.
outline([(0, -10, 0), (140, -10, 0), (170, -32, 0), (220, -32, 0), (220, -22, 0), (175, -22, 0), (153, -3, -0.5), (153, 1, 0),
         (175, 18, 0), (220, 18, 0), (220, 32, 0), (168, 32, 0), (140, 10, 0), (122, 10, 0), (122, 40, ROUND), (112, 50, 0),
         (48, 50, ROUND), (38, 40, 0), (38, 10, 0), (0, 10, 0)], "CHANNELS")
# Between the channel and its bypass, with rounded corners.
outline([(53, 10, 0), (107, 10, ROUND), (110, 13, 0), (110, 35, ROUND), (105, 40, 0), (55, 40, ROUND), (50, 35, 0), (50, 13, ROUND)], "CHANNELS")
outline([(-20, -60, 0), (240, -60, 0), (240, 70, 0), (-20, 70, 0)], "FRAME")
for name, x, y in (("inlet", -15, 15), ("wide", 222, 22), ("narrow", 222, -30)):
    space.add_text(name, dxfattribs={"layer": "LABELS", "height": 5e-3, "insert": (x * 1e-3, y * 1e-3)})
doc.saveas(pathlib.Path(__file__).parent / "chip.dxf")
