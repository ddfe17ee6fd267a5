"""Loops of a drawing: loose pieces joined, keyholes cut, holes by nesting, pieces that touch or overlap as one."""
from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import polygonize, unary_union
from shapely.strtree import STRtree
from shapely.validation import explain_validity

from .drawing import Drawing, Line, Refused, counted, place
from .joining import join

FINEST = 1e-6  # [µm] to which places are written
SLIVER = 2e-3  # [µm] thinner than this is rounding: GDSII has steps of 0.001 µm


@dataclass
class Outlines:
    loops: list[np.ndarray]  # [µm]
    area: float  # [µm²] within them
    found: list[str]


def is_sliver(shape) -> bool:
    return shape.area <= 0.5 * SLIVER * shape.length


def winding(ring: np.ndarray, point) -> int:
    """How often a closed ring goes round a point, anticlockwise."""
    a, b = ring - point, np.roll(ring, -1, 0) - point
    side = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    up, down = (a[:, 1] <= 0) & (b[:, 1] > 0) & (side > 0), (a[:, 1] > 0) & (b[:, 1] <= 0) & (side < 0)
    return int(up.sum() - down.sum())


def crossings(a: np.ndarray, b: np.ndarray, most: int = 4000) -> list[np.ndarray]:
    """Where segments of two closed rings pass through each other."""
    if len(a) * len(b) > most * most:
        return []
    p, r = a, np.roll(a, -1, 0) - a
    found = []
    for q, s in zip(b, np.roll(b, -1, 0) - b):
        across = r[:, 0] * s[1] - r[:, 1] * s[0]
        with np.errstate(divide="ignore", invalid="ignore"):
            d = q - p
            t = (d[:, 0] * s[1] - d[:, 1] * s[0]) / across
            u = (d[:, 0] * r[:, 1] - d[:, 1] * r[:, 0]) / across
        hit = (across != 0) & (t > 1e-9) & (t < 1 - 1e-9) & (u > 1e-9) & (u < 1 - 1e-9)
        found.extend(p[hit] + t[hit, None] * r[hit])
    return found


def first_ten(faults: list[str]) -> list[str]:
    return faults[:10] + ([f"and {len(faults) - 10} more faults like these"] if len(faults) > 10 else [])


def told_places(points) -> str:
    distinct = list(dict.fromkeys(place(point) for point in points))
    return " and ".join(distinct[:4]) + (f" and at {len(distinct) - 4} more places" if len(distinct) > 4 else "")


def crosses_itself(line: Line) -> str:
    places = crossings(line.points, line.points)
    if not places:
        places = [tuple(map(float, pair)) for pair in re.findall(r"\[(\S+) (\S+)\]", explain_validity(Polygon(line.points)))]
    return f"the outline of {line.what} crosses itself at {told_places(places)}; draw it without"


def filled(line: Line, union: bool):
    """What a closed line goes round, as a shape; keyholes and spurs are cut. A text where it crosses itself."""
    shape = Polygon(line.points)
    if shape.is_valid:
        return shape
    ring = LineString(np.vstack([line.points, line.points[:1]]))
    faces = [face for face in polygonize(unary_union(ring)) if not is_sliver(face)]
    turns = [winding(line.points, np.array(face.representative_point().coords[0])) for face in faces]
    signs = {np.sign(turn) for turn in turns if turn != 0}
    if len(signs) > 1 or (not union and any(abs(turn) > 1 for turn in turns)):
        return crosses_itself(line)
    return unary_union([face for face, turn in zip(faces, turns) if turn != 0])


def near(shapes) -> list[list[int]]:
    """Of each shape those others whose boxes touch its own."""
    tree = STRtree(shapes)
    number = {id(shape): k for k, shape in enumerate(shapes)}
    result = []
    for k, shape in enumerate(shapes):
        hits = [int(hit) if isinstance(hit, (int, np.integer)) else number[id(hit)] for hit in tree.query(shape)]
        result.append(sorted(hit for hit in hits if hit != k))
    return result


def without_doubles(shapes, lines, off: float):
    """One of each shape that was drawn twice, as a hatch within its outline is."""
    kept = []
    drop = set()
    for k, others in enumerate(near(shapes)):
        if k in drop:
            continue
        for other in others:
            if other > k and np.allclose(shapes[k].bounds, shapes[other].bounds, atol=2 * off, rtol=0) and \
                    shapes[k].symmetric_difference(shapes[other]).area <= off * shapes[k].length:
                drop.add(other)
        kept.append(k)
    return [shapes[k] for k in kept], [lines[k] for k in kept], len(drop)


def nested(shapes, lines):
    """The even–odd sum of shapes, none of which crosses another. Refuses those that do."""
    faults = []
    inside = np.zeros(len(shapes), int)  # how many others each lies in
    for k, others in enumerate(near(shapes)):
        for other in others:
            common = shapes[k].intersection(shapes[other])
            if is_sliver(common):
                continue
            smaller = shapes[k] if shapes[k].area <= shapes[other].area else shapes[other]
            if not is_sliver(smaller.difference(common)):
                if other > k:
                    places = crossings(lines[k].points, lines[other].points) or \
                        [g.representative_point().coords[0] for g in [common]]
                    faults.append(f"the outlines of {lines[k].what} and {lines[other].what} cross at {told_places(places)}; "
                                  "unite or subtract them in the drawing program")
            elif smaller is shapes[k] and (shapes[k].area < shapes[other].area or other < k):
                inside[k] += 1
    if faults:
        raise Refused(*first_ten(faults))
    whole = Polygon()
    for depth in range(inside.max() + 1):
        level = unary_union([shape for shape, count in zip(shapes, inside) if count == depth])
        whole = whole.union(level) if depth % 2 == 0 else whole.difference(level)
    return whole


def loop_of(ring) -> np.ndarray | None:
    """Corners of a ring to FINEST, from the one that is leftmost and lowest; nothing where none are left."""
    points = np.array(ring.coords)[:-1]
    first = min(range(len(points)), key=lambda k: tuple(points[k]))
    closed = np.vstack([points[first:], points[:first + 1]])
    points = np.round(np.array(LineString(closed).simplify(0.5 * FINEST).coords)[:-1], 6) + 0.0
    points = points[np.any(points != np.roll(points, 1, 0), axis=1)]
    return points if len(points) > 2 else None


def pieces_of(shape):
    """The polygons of a shape that are no slivers, their holes likewise."""
    parts = getattr(shape, "geoms", [shape])
    for part in parts:
        if part.geom_type == "Polygon" and not part.is_empty and not is_sliver(part):
            yield Polygon(part.exterior, [hole for hole in part.interiors if not is_sliver(Polygon(hole))])


def outlines(drawing: Drawing, off: float) -> Outlines:
    lines, found = join(drawing.lines)
    shapes, kept, faults = [], [], []
    for line in lines:
        shape = filled(line, drawing.union)
        if isinstance(shape, str):
            faults.append(shape)
        elif not is_sliver(shape):
            shapes.append(shape)
            kept.append(line)
    if faults:
        raise Refused(*first_ten(faults))
    if not shapes:
        raise Refused("nothing in the file goes round an area")
    if drawing.union:
        whole = unary_union(shapes)
    else:
        shapes, kept, doubles = without_doubles(shapes, kept, off)
        if doubles:
            found.append(f"{counted(doubles, 'outline')} drawn twice, taken once")
        whole = nested(shapes, kept)
    pieces = list(pieces_of(whole))
    loops = [loop_of(ring) for piece in pieces for ring in (piece.exterior, *piece.interiors)]
    loops = sorted((loop for loop in loops if loop is not None), key=lambda loop: (*loop[0], len(loop), *loop[1]))
    loops = [loop if signed_area(loop) > 0 else np.roll(loop[::-1], 1, 0) for loop in loops]
    return Outlines(loops, sum(piece.area for piece in pieces), found)


def signed_area(loop: np.ndarray) -> float:
    after = np.roll(loop, -1, 0)
    return 0.5 * float(np.sum(loop[:, 0] * after[:, 1] - loop[:, 1] * after[:, 0]))
